#include "presentation/csv_field.hpp"

#include "diagnostics/terminal.hpp"

namespace axisc::presentation {

std::string csv_text(std::string_view text) {
  bool const is_formula =
      !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
  return (is_formula ? "'" : "") + printable(text);
}

void append_csv_field(std::string& line, std::string_view field) {
  if (field.find_first_of(",\"") == std::string_view::npos) {
    line += field;
    return;
  }
  line += '"';
  for (char const character : field) {
    if (character == '"') line += '"';
    line += character;
  }
  line += '"';
}

}  // namespace axisc::presentation
