// Numbers in columns, read and written row by row: memory does not grow with the length.
#pragma once

#include "analysis/recordings/text_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

using recordings::ByteSource;

/// First line: column names. Fields are separated by commas and may be in double quotes; blanks around them,
/// CRLF, a byte order mark and empty lines are accepted. A mistake is a Failure (AX9005) with line and
/// column.
class CsvReader {
 public:
  /// Reads the first line. `name` is the file in messages.
  CsvReader(std::string name, ByteSource source);

  [[nodiscard]] std::vector<std::string> const& header() const { return header_; }
  /// The next row's numbers, one per column; false at the end.
  [[nodiscard]] bool next(std::span<double> row);
  /// Failure about column `index` of the header that lists the known columns.
  [[noreturn]] void refuse_column(std::size_t index, std::string_view known) const;

 private:
  struct Field {
    std::string_view text;
    std::uint32_t column = 1;  ///< in code points, from 1
  };

  /// The next line that is not blank, without its end; false at the end of the file.
  bool next_line();
  void split_line();

  std::string name_;
  recordings::TextLines lines_;
  std::string_view line_;      ///< of lines_
  std::uint64_t number_ = 0;   ///< of line_, from 1
  std::vector<Field> fields_;  ///< of line_
  std::vector<std::string> header_;
  std::vector<std::uint32_t> header_columns_;
  std::uint64_t header_line_ = 0;
};

/// A name as CSV files have it: printable, and nothing that a spreadsheet would take for a formula.
[[nodiscard]] std::string csv_name(std::string_view name);
/// Appends csv_name() as a field, quoted if needed.
void append_csv_name(std::string& line, std::string_view name);

/// Appends a row of numbers so that reading them gives the same doubles, with a line end.
void append_csv_row(std::string& text, std::span<double const> row);

}  // namespace axisc
