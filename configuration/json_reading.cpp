#include "configuration/json_reading.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/closest_word.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace axisc::configuration {

void JsonReading::fill(JsonShape const& shape, JsonValue const& object, void* target) const {
  for (JsonKey const& key : shape.keys) {
    JsonMember const* const member = object.find(key.name);
    if (key.store == nullptr || member == nullptr || !readable_[member->value]) continue;
    key.store(*this, *key.shape, document_[member->value], target);
  }
}

void JsonReading::assign(JsonShape const& shape, JsonValue const& value, std::string& target) {
  target = value.string;
  for (std::string_view const word : shape.words) {
    if (ascii::equal_ignoring_case(word, value.string)) target = word;
  }
}

void JsonReading::assign(JsonShape const& shape, JsonValue const& value, LocatedText& target) const {
  assign(shape, value, target.text);
  target.place = {.source = source_, .span = value.span};
}

void JsonReading::assign(JsonShape const& /*shape*/, JsonValue const& value, bool& target) {
  target = value.flag;
}

void JsonReading::assign(JsonShape const& /*shape*/, JsonValue const& value, design::CycleTime& target) {
  target = design::CycleTime{static_cast<std::uint32_t>(std::round(value.number * 1e3))};
}

}  // namespace axisc::configuration
