#include "validator/list_layout.hpp"

#include "diagnostics/utf8.hpp"
#include "grammar/axis_list.hpp"
#include "validator/values/kind_of_list.hpp"
#include "validator/values/list_reader.hpp"
#include "validator/values/reading.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t tab_width = 8;
/// Longer values do not move the comments of neighbouring lines.
constexpr std::size_t widest_value = 32;
/// Longer lines are left unchanged: otherwise neighbouring lines would grow with them, finally beyond readability.
constexpr std::size_t longest_aligned_line = 1024;

/// A list keeps its own columns if it has so many lines, of which so many have their values in one column.
constexpr std::size_t smallest_layout = 12;
constexpr std::size_t layout_percent = 75;

/// An assignment in three parts; `comment` may be empty.
struct Row {
  Span line;
  std::string_view indent;
  std::string_view name;
  std::string_view value;
  std::string_view comment;
  std::uint32_t number = 0;
};

std::string_view without_blanks_behind(std::string_view text) {
  std::size_t const last = text.find_last_not_of(" \t");
  return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

/// After these values the control treats any text as a comment.
bool ends_at_blank(grammar::Assignment const& assignment, Reading const& reading) {
  using grammar::ValueKind;
  if (!reading.usable()) return false;
  if (reading.status == ReadingStatus::reference) return true;
  schema::Parameter const& parameter = *reading.row;
  if (parameter.type == schema::DataType::boolean) return true;
  if (parameter.type == schema::DataType::string && !parameter.is_enumeration()) return false;
  return assignment.kind == ValueKind::integer || assignment.kind == ValueKind::hexadecimal ||
         assignment.kind == ValueKind::real;
}

class Layout {
 public:
  Layout(SourceText const& source, schema::Catalogue const& catalogue)
      : source_(source), list_(judge_list(source, grammar::parse_axis_list(source), catalogue)) {}

  [[nodiscard]] bool is_axis_list() const {
    return kind_of_list(source_, list_.tree, list_.readings) == configuration::ListKind::axis;
  }

  std::string write() && {
    auto const rows = this->rows();
    file_column_ = common_column(rows, &Row::value);
    comment_column_ = file_column_ == 0 ? 0 : common_column(rows, &Row::comment);
    for (std::size_t begin = 0; begin < rows.size();) {
      std::size_t end = begin + 1;
      while (end < rows.size() && rows[end].number == rows[end - 1].number + 1) ++end;
      write_paragraph({rows.begin() + static_cast<std::ptrdiff_t>(begin),
                       rows.begin() + static_cast<std::ptrdiff_t>(end)});
      begin = end;
    }
    out_ += source_.bytes().substr(copied_);
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::vector<Row> rows() const {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < list_.readings.size(); ++i) {
      grammar::Assignment const& assignment = list_.tree.assignments[i];
      Span const line = source_.line_span(assignment.line);
      if (line.size() > longest_aligned_line) continue;
      Reading const reading = list_.readings[i];
      Span const value = ends_at_blank(assignment, reading) ? assignment.value
                                                            : grammar::free_text(source_.bytes(), assignment);
      // `4(` is not a number, and must not become one.
      if (!reading.usable() && value.end < assignment.value.end) continue;
      rows.push_back({.line = line,
                      .indent = source_.slice({.begin = line.begin, .end = assignment.name.begin}),
                      .name = source_.slice(assignment.name),
                      .value = source_.slice(value),
                      .comment = comment_behind(value.end, line.end),
                      .number = assignment.line});
    }
    return rows;
  }

  [[nodiscard]] std::string_view comment_behind(std::uint32_t value_end, std::uint32_t line_end) const {
    std::string_view const rest = without_blanks_behind(source_.slice({.begin = value_end, .end = line_end}));
    return rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()));
  }

  [[nodiscard]] std::size_t width(std::string_view text) const {
    if (source_.encoding() == Encoding::windows_1252) return text.size();
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return !is_continuation_byte(byte); }));
  }

  /// The column that most rows have in common for one of their parts; 0 where there is none.
  [[nodiscard]] std::size_t common_column(std::vector<Row> const& rows, std::string_view Row::*part) const {
    std::map<std::size_t, std::size_t> rows_at;
    std::size_t count = 0;
    for (Row const& row : rows) {
      if ((row.*part).empty()) continue;
      auto const begin = static_cast<std::size_t>((row.*part).data() - source_.bytes().data());
      ++rows_at[columns(source_.bytes().substr(row.line.begin, begin - row.line.begin))];
      ++count;
    }
    for (auto const& [column, number] : rows_at) {
      if (count >= smallest_layout && number * 100 >= count * layout_percent) return column;
    }
    return 0;
  }

  [[nodiscard]] std::size_t columns(std::string_view text) const {
    std::size_t column = 0;
    for (std::size_t at = text.find('\t'); at != std::string_view::npos; at = text.find('\t')) {
      column = ((column + width(text.substr(0, at))) / tab_width + 1) * tab_width;
      text.remove_prefix(at + 1);
    }
    return column + width(text);
  }

  /// Columns before the value: the indentation is preserved.
  [[nodiscard]] std::size_t name_end(Row const& row) const { return columns(row.indent) + width(row.name); }

  void write_paragraph(std::vector<Row> const& rows) {
    std::size_t value_column = 0;
    std::size_t value_width = 0;
    for (Row const& row : rows) {
      value_column = std::max(value_column, name_end(row) + gap);
      std::size_t const wide = width(row.value);
      if (!row.comment.empty() && wide <= widest_value) value_width = std::max(value_width, wide);
    }
    for (Row const& row : rows) {
      out_ += source_.bytes().substr(copied_, row.line.begin - copied_);
      copied_ = row.line.end;
      out_ += row.indent;
      out_ += row.name;
      std::size_t const begin =
          file_column_ == 0 ? value_column : std::max(file_column_, name_end(row) + gap);
      out_.append(begin - name_end(row), ' ');
      out_ += row.value;
      if (row.comment.empty()) continue;
      std::size_t const wide = width(row.value);
      std::size_t const end = begin + wide;
      std::size_t const comment =
          comment_column_ == 0 ? begin + std::max(wide, value_width) + gap : comment_column_;
      out_.append(std::max(comment, end + gap) - end, ' ');
      out_ += row.comment;
    }
  }

  SourceText const& source_;
  ReadList list_;
  std::string out_;
  std::uint32_t copied_ = 0;
  std::size_t file_column_ = 0;     ///< of the values of the whole list, where it has one
  std::size_t comment_column_ = 0;  ///< of its comments
};

}  // namespace

std::string aligned_list(SourceText const& source, schema::Catalogue const& catalogue) {
  Layout layout(source, catalogue);
  return layout.is_axis_list() ? std::move(layout).write() : std::string(source.bytes());
}

}  // namespace axisc::validator
