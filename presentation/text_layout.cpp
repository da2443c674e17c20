#include "presentation/text_layout.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace axisc::presentation {

namespace {

constexpr std::string_view gap = "  ";
constexpr std::size_t narrowest_wrapped = 20;
constexpr std::size_t most_heading_lines = 2;

void append_cell(std::string& line, std::string_view cell, std::size_t width, bool is_right) {
  auto const used = display_width(cell);
  std::size_t const blanks = used < width ? width - used : 0;
  if (is_right) line.append(blanks, ' ');
  line += cell;
  if (!is_right) line.append(blanks, ' ');
}

std::vector<std::string> lines_of(std::string const& cell, std::size_t width) {
  if (display_width(cell) <= width) return {cell};
  std::vector<std::string> lines;
  std::istringstream text(wrapped(cell, width));
  for (std::string line; std::getline(text, line);) lines.push_back(std::move(line));
  return lines;
}

std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  while (!text.empty()) {
    auto const word = text.substr(0, text.find(' '));
    longest = std::max(longest, display_width(word));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return longest;
}

/// Some columns of a table, with the widths of all.
class Lines {
 public:
  Lines(ShownTable const& table, std::size_t width) : table_(table) {
    for (std::size_t i = 0; i < table.headings.size(); ++i) {
      cells_.push_back(0);
      for (auto const& row : table.rows) cells_[i] = std::max(cells_[i], display_width(row[i]));
      widths_.push_back(std::max(cells_[i], display_width(table.headings[i])));
    }
    auto const before = [this] {
      return std::accumulate(widths_.begin(), widths_.end() - 1, gap.size() * widths_.size());
    };
    if (widths_.empty() || before() + widths_.back() <= width) return;
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      widths_[i] = std::max(cells_[i], longest_word(table.headings[i]));
      while (lines_of(table.headings[i], widths_[i]).size() > most_heading_lines) ++widths_[i];
    }
    bool const is_wrapped = !table.is_right.back() && before() + widths_.back() > width;
    auto narrowest = narrowest_wrapped;
    for (auto const& row : table.rows) narrowest = std::max(narrowest, longest_word(row.back()));
    if (is_wrapped && before() + narrowest <= width) widths_.back() = width - before();
  }

  /// Text that is wider even alone beside the head columns is wrapped.
  void limit(std::size_t column, std::size_t width) {
    if (table_.is_right[column]) return;
    widths_[column] = std::min(widths_[column], std::max(width, narrowest_wrapped));
  }
  [[nodiscard]] std::size_t width_of(std::size_t column) const { return widths_[column] + gap.size(); }

  [[nodiscard]] std::string of(std::vector<std::size_t> const& columns) const {
    std::string text;
    append(text, table_.headings, columns, true);
    for (auto const& row : table_.rows) append(text, row, columns, false);
    return text;
  }

 private:
  /// Headings stand above their columns, whatever their height.
  void append(std::string& text, std::vector<std::string> const& cells,
              std::vector<std::size_t> const& columns, bool is_at_bottom) const {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 0;
    for (auto const column : columns) {
      height = std::max(height, lines.emplace_back(lines_of(cells[column], widths_[column])).size());
    }
    for (std::size_t at = 0; at < height; ++at) {
      std::string line;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        auto const first = is_at_bottom ? height - lines[i].size() : 0;
        bool const is_filled = at >= first && at - first < lines[i].size();
        append_cell(line += gap, is_filled ? lines[i][at - first] : std::string(), widths_[columns[i]],
                    table_.is_right[columns[i]]);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      (text += line) += '\n';
    }
  }

  ShownTable const& table_;
  std::vector<std::size_t> cells_;  ///< without the headings
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

std::string hanging(std::string_view text, std::size_t width, std::size_t column) {
  auto const lines = wrapped(text, std::max(width, column + narrowest_wrapped) - column);
  std::string shown;
  for (char const byte : std::string_view(lines).substr(0, lines.size() - 1)) {
    shown += byte;
    if (byte == '\n') shown.append(column, ' ');
  }
  return shown;
}

std::string table_text(ShownTable const& table, std::size_t width) {
  Lines lines(table, width);
  std::vector<std::size_t> heads;
  std::size_t head_width = 0;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (!table.is_head[i]) continue;
    heads.push_back(i);
    head_width += lines.width_of(i);
  }
  auto const rest = width - std::min(width, head_width + gap.size());
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (!table.is_head[i]) lines.limit(i, rest);
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
