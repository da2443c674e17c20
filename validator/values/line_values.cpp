#include "validator/values/line_values.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace axisc::validator {

LineValue LineValues::operator[](std::size_t assignment) const {
  BriefReading const& brief = brief_[assignment];
  if (brief.other != 0) return others_[brief.other - 1];
  LineValue line_value;
  line_value.slot = schema::Slot{brief.slot};
  line_value.row = &catalogue_.parameter_of(line_value.slot);
  line_value.name_status = schema::NameLookup::Status::found;
  line_value.status = ReadingStatus::value;
  line_value.text = assignments_[assignment].value;
  line_value.value.number = brief.number;
  if (brief.text == BriefReading::own_text) {
    line_value.value.text = bytes_.substr(line_value.text.begin, line_value.text.size());
  } else if (brief.text != BriefReading::no_text) {
    line_value.value.text = line_value.row->symbols[brief.text - std::size_t{1}].word;
  }
  return line_value;
}

std::optional<schema::Slot> LineValues::slot(std::size_t assignment) const {
  BriefReading const& brief = brief_[assignment];
  if (brief.other == 0) return schema::Slot{brief.slot};
  LineValue const& line_value = others_[brief.other - 1];
  return line_value.known() ? std::optional(line_value.slot) : std::nullopt;
}

schema::NameSuggestions const& LineValues::suggestions(std::size_t assignment) const {
  auto const found = std::lower_bound(
      suggested_.begin(), suggested_.end(), assignment,
      [](Suggested const& suggested, std::size_t wanted) { return suggested.assignment < wanted; });
  static schema::NameSuggestions const none;
  if (found == suggested_.end() || found->assignment != assignment) return none;
  return found->names;
}

}  // namespace axisc::validator
