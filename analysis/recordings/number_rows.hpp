// Numbers in columns as scopes and measuring programs write them: the one reader of recordings and
// measurements.
//
//   separators   tabs, semicolons or commas, whichever of them the first row of numbers has, in this order
//   numbers      finite, unless the caller accepts others; with decimal points, or with decimal commas
//                where commas do not separate. The whole column decides: one that has both is refused, so
//                that thousands separators are not taken for decimals
//   headers      lines before the first row of numbers; the last of them with as many fields names the
//                columns, which are "1", "2", … without one
//   left out     blank lines, blanks and quotation marks around a field, an empty field after the last
//                separator of a line, a byte order mark
//   the end      of the text, or a line `EOF`
//
// TwinCAT Scope's export is such a text: header lines, a pair of time and value for each signal, `EOF`.
#pragma once

#include "analysis/recordings/text_lines.hpp"

#include <optional>
#include <vector>

namespace axisc::recordings {

enum class RowProblem : std::uint8_t {
  no_rows,       ///< no line of numbers
  not_a_number,  ///< `text`
  field_count,   ///< `fields`
  mixed_marks,   ///< decimal commas and decimal points in `column`
  long_line,     ///< more than longest_line bytes
};

struct BadRow {
  RowProblem problem = RowProblem::no_rows;
  std::uint64_t line = 0;  ///< from 1; of no_rows the last one
  std::size_t column = 0;  ///< of not_a_number and mixed_marks, from 0
  std::size_t fields = 0;  ///< of field_count
  std::string text = {};   ///< of not_a_number, valid UTF-8 and not long
};

/// Whether "inf" and "nan" are numbers.
enum class Accepts : std::uint8_t { finite, any };

/// Rows one after the other; memory does not grow with their number.
class NumberRows {
 public:
  enum class Step : std::uint8_t { row, end, bad };

  /// Reads the headers and the first row; problem() is set where there is none.
  explicit NumberRows(ByteSource source, Accepts accepts = Accepts::finite);

  /// Names of the columns, at least two unless there is a problem.
  [[nodiscard]] std::vector<std::string> const& names() const { return names_; }
  [[nodiscard]] bool is_named() const { return is_named_; }
  [[nodiscard]] std::uint64_t line() const { return lines_.number(); }  ///< of the last row

  /// Restricts next() to these columns; the others may hold any text. Without a call, all are read.
  void read_only(std::vector<std::size_t> const& columns);

  /// A value for each column; those that are not read stay as they are.
  [[nodiscard]] Step next(std::span<double> row);
  [[nodiscard]] std::optional<BadRow> const& problem() const { return problem_; }

 private:
  struct Marks {
    bool comma = false, point = false;
  };

  Step fail(BadRow bad);
  void split(std::string_view line);
  [[nodiscard]] std::optional<double> number_of(std::string_view field) const;

  TextLines lines_;
  Accepts accepts_;
  char separator_ = ',';
  bool is_named_ = false;
  bool has_first_ = false;  ///< in fields_, not handed out yet
  std::vector<std::string> names_;
  std::vector<bool> is_read_;
  std::vector<Marks> marks_;
  std::vector<std::string_view> fields_;
  std::optional<BadRow> problem_;
};

}  // namespace axisc::recordings
