// Fields of CSV files.
#pragma once

#include <string>
#include <string_view>

namespace axisc::presentation {

/// A foreign text as CSV files have it: printable, and nothing that a spreadsheet would take for a formula.
[[nodiscard]] std::string csv_text(std::string_view text);

/// Appends a field, quoted if needed.
void append_csv_field(std::string& line, std::string_view field);

}  // namespace axisc::presentation
