#include "validator/list_layout.hpp"

#include "diagnostics/utf8.hpp"
#include "grammar/axis_list.hpp"
#include "validator/values/kind_of_list.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

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
/// Longer lines are left unchanged: otherwise neighbouring lines would grow with them, finally beyond
/// readability.
constexpr std::size_t longest_aligned_line = 1024;

/// A list keeps its own columns if it has this many lines, of which this share has its values in one column.
constexpr std::size_t smallest_layout = 12;
constexpr std::size_t layout_percent = 75;
constexpr std::size_t widest_column = 200;

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
bool ends_at_blank(grammar::Assignment const& assignment, LineValue const& line_value) {
  using grammar::ValueKind;
  if (!line_value.usable()) return false;
  if (line_value.status == ReadingStatus::reference) return true;
  schema::Parameter const& parameter = *line_value.row;
  if (parameter.type == schema::DataType::boolean) return true;
  if (parameter.type == schema::DataType::string && !parameter.is_enumeration()) return false;
  return assignment.kind == ValueKind::integer || assignment.kind == ValueKind::hexadecimal ||
         assignment.kind == ValueKind::real;
}

class Layout {
 public:
  Layout(SourceText const& source, schema::Catalogue const& catalogue)
      : source_(source), list_(judge_list(source, grammar::parse_axis_list(source), catalogue)) {}

  [[nodiscard]] std::optional<configuration::ListKind> kind() const {
    return kind_of_list(source_, list_.tree, list_.line_values);
  }

  /// True if write() kept one column for all values of the list.
  [[nodiscard]] bool keeps_columns() const { return file_column_ != 0; }

  std::string write() {
    auto const rows = this->rows();
    file_column_ = common_column(rows, [this](Row const& row) { return column_of(row, row.value); });
    if (file_column_ != 0) {
      // Comments stay where they are only if the values before them end in time.
      comment_column_ = common_column(rows, [this](Row const& row) {
        auto const column = row.comment.empty() ? 0 : column_of(row, row.comment);
        return column > value_begin(row) + width(row.value) ? column : 0;
      });
    }
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
    for (std::size_t i = 0; i < list_.line_values.size(); ++i) {
      grammar::Assignment const& assignment = list_.tree.assignments[i];
      Span const line = source_.line_span(assignment.line);
      if (line.size() > longest_aligned_line) continue;
      LineValue const line_value = list_.line_values[i];
      Span const value = ends_at_blank(assignment, line_value)
                             ? assignment.value
                             : grammar::free_text(source_.bytes(), assignment);
      // `4(` is not a number, and must not become one.
      if (!line_value.usable() && value.end < assignment.value.end) continue;
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

  /// The column that most rows have in common; 0 where there is none.
  template <typename Column>
  [[nodiscard]] static std::size_t common_column(std::vector<Row> const& rows, Column column) {
    std::map<std::size_t, std::size_t> rows_at;
    for (Row const& row : rows) ++rows_at[column(row)];
    std::size_t const count = rows.size() - rows_at[0];
    for (auto const& [at, number] : rows_at) {
      bool const is_usual = at != 0 && at <= widest_column && number * 100 >= count * layout_percent;
      if (is_usual && count >= smallest_layout) return at;
    }
    return 0;
  }

  [[nodiscard]] std::size_t column_of(Row const& row, std::string_view part) const {
    auto const begin = static_cast<std::size_t>(part.data() - source_.bytes().data());
    return columns(source_.bytes().substr(row.line.begin, begin - row.line.begin));
  }

  /// With one column for all values of the list.
  [[nodiscard]] std::size_t value_begin(Row const& row) const {
    return std::max(file_column_, name_end(row) + 1);
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
      std::size_t const begin = file_column_ == 0 ? value_column : value_begin(row);
      out_.append(begin - name_end(row), ' ');
      out_ += row.value;
      if (row.comment.empty()) continue;
      std::size_t const wide = width(row.value);
      std::size_t const end = begin + wide;
      std::size_t comment = begin + std::max(wide, value_width) + gap;
      if (comment_column_ != 0) comment = std::max(comment_column_, end + 1);
      out_.append(comment - end, ' ');
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

std::string aligned_list(SourceText const& source, schema::Catalogue const& catalogue, AlignedKinds kinds) {
  using configuration::ListKind;
  Layout layout(source, catalogue);
  auto const kind = layout.kind();
  bool const is_axis_list = kind.value_or(ListKind::axis) == ListKind::axis;
  bool const stays = (kinds == AlignedKinds::axis_or_unknown && !is_axis_list) ||
                     (kinds == AlignedKinds::axis && kind != ListKind::axis);
  if (stays) return std::string(source.bytes());
  bool const is_other = catalogue.kind() == ListKind::axis && kind && kind != ListKind::axis;
  if (is_other) return aligned_list(source, schema::Catalogue::of(*kind), kinds);
  auto text = layout.write();
  if (layout.keeps_columns() || text == source.bytes()) return text;
  // The paragraphs may have got a common column only now.
  return Layout(SourceText(source.name(), text), catalogue).write();
}

}  // namespace axisc::validator
