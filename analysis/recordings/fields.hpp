// A line of a text as fields.
#pragma once

#include <string_view>
#include <vector>

namespace axisc::recordings {

/// Fields without the blanks and quotation marks around them. Where blanks separate, two of them are a field
/// that is blank, as scopes write it for a group that has ended, and one where a field begins is an empty
/// field.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// Without empty fields after the last separator.
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// Tabs, semicolons or commas, whichever the line has, in this order.
[[nodiscard]] char usual_separator(std::string_view line);

}  // namespace axisc::recordings
