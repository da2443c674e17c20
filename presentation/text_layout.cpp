#include "presentation/text_layout.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

constexpr std::string_view gap = "  ";

void append_cell(std::string& line, std::string_view cell, std::size_t width, bool is_right) {
  auto const used = display_width(cell);
  std::size_t const blanks = used < width ? width - used : 0;
  if (is_right) line.append(blanks, ' ');
  line += cell;
  if (!is_right) line.append(blanks, ' ');
}

/// Some columns of a table, with the widths of all.
class Lines {
 public:
  explicit Lines(ShownTable const& table) : table_(table) {
    for (auto const& heading : table.headings) widths_.push_back(display_width(heading));
    for (auto const& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) widths_[i] = std::max(widths_[i], display_width(row[i]));
    }
  }

  [[nodiscard]] std::size_t width_of(std::size_t column) const { return widths_[column] + gap.size(); }

  [[nodiscard]] std::string of(std::vector<std::size_t> const& columns) const {
    std::string text;
    append(text, table_.headings, columns);
    for (auto const& row : table_.rows) append(text, row, columns);
    return text;
  }

 private:
  void append(std::string& text, std::vector<std::string> const& cells,
              std::vector<std::size_t> const& columns) const {
    std::string line;
    for (auto const column : columns) {
      append_cell(line += gap, cells[column], widths_[column], table_.is_right[column]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    (text += line) += '\n';
  }

  ShownTable const& table_;
  std::vector<std::size_t> widths_;
};

}  // namespace

std::size_t display_width(std::string_view text) {
  return text.size() - count_continuation_bytes(text);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string lines;
  std::size_t column = 0;
  while (!text.empty()) {
    auto end = text.find(' ');
    bool const is_number =
        end != std::string_view::npos && end > 0 && text[end - 1] >= '0' && text[end - 1] <= '9';
    if (is_number) end = text.find(' ', end + 1);
    auto const word = text.substr(0, end);
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    auto const size = display_width(word);
    if (column > indent && column + 1 + size > width) {
      lines.append("\n").append(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += size;
  }
  return lines + "\n";
}

std::string table_text(ShownTable const& table, std::size_t width) {
  Lines const lines(table);
  std::vector<std::size_t> heads;
  std::size_t head_width = 0;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (!table.is_head[i]) continue;
    heads.push_back(i);
    head_width += lines.width_of(i);
  }
  std::string text;
  auto group = heads;
  auto used = head_width;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (table.is_head[i]) continue;
    if (group.size() > heads.size() && used + lines.width_of(i) > width) {
      text += lines.of(group) + "\n";
      group = heads;
      used = head_width;
    }
    group.push_back(i);
    used += lines.width_of(i);
  }
  text += lines.of(group);
  if (!table.more.empty()) text.append(gap).append(table.more).append("\n");
  return text;
}

}  // namespace axisc::presentation
