#include "validator/values/readings.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace axisc::validator {

Reading Readings::operator[](std::size_t assignment) const {
  BriefReading const& brief = brief_[assignment];
  if (brief.other != 0) return others_[brief.other - 1];
  Reading reading;
  reading.slot = schema::Slot{brief.slot};
  reading.row = &catalogue_.parameter_of(reading.slot);
  reading.name_status = schema::NameLookup::Status::found;
  reading.status = ReadingStatus::value;
  reading.text = assignments_[assignment].value;
  reading.value.number = brief.number;
  if (brief.text == BriefReading::own_text) {
    reading.value.text = bytes_.substr(reading.text.begin, reading.text.size());
  } else if (brief.text != BriefReading::no_text) {
    reading.value.text = reading.row->symbols[brief.text - std::size_t{1}].word;
  }
  return reading;
}

std::optional<schema::Slot> Readings::slot(std::size_t assignment) const {
  BriefReading const& brief = brief_[assignment];
  if (brief.other == 0) return schema::Slot{brief.slot};
  Reading const& reading = others_[brief.other - 1];
  return reading.known() ? std::optional(reading.slot) : std::nullopt;
}

schema::NameSuggestions const& Readings::suggestions(std::size_t assignment) const {
  auto const found = std::lower_bound(
      suggested_.begin(), suggested_.end(), assignment,
      [](Suggested const& suggested, std::size_t wanted) { return suggested.assignment < wanted; });
  static schema::NameSuggestions const none;
  if (found == suggested_.end() || found->assignment != assignment) return none;
  return found->names;
}

}  // namespace axisc::validator
