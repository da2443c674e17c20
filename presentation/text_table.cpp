#include "presentation/text_table.hpp"

#include "diagnostics/terminal.hpp"

#include <algorithm>

namespace axisc::presentation {

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  auto const now = display_width(text);
  if (now < width) result.append(width - now, ' ');
  return result;
}

std::string text_table(std::span<std::vector<std::string> const> rows, std::size_t indent) {
  std::vector<std::vector<std::string>> shown(rows.begin(), rows.end());
  for (auto& row : shown) std::transform(row.begin(), row.end(), row.begin(), printable);
  std::vector<std::size_t> widths;
  for (auto const& row : shown) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  std::string text;
  for (auto const& row : shown) {
    std::string line(indent, ' ');
    for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i]) + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace axisc::presentation
