#include "analysis/tuning/identification/number_table.hpp"

#include "analysis/recordings/number_rows.hpp"

namespace axisc::tuning {
namespace {

BadMeasurement bad_row(recordings::NumberRows const& rows) {
  using recordings::RowProblem;
  auto const& bad = *rows.problem();
  auto const line = static_cast<std::size_t>(bad.line);
  switch (bad.problem) {
    case RowProblem::not_a_number: return {.problem = MeasurementProblem::not_a_number, .line = line};
    case RowProblem::field_count: return {.problem = MeasurementProblem::field_count, .line = line};
    case RowProblem::mixed_marks:
      return {.problem = MeasurementProblem::mixed_numbers, .line = line, .column = rows.names()[bad.column]};
    case RowProblem::long_line: return {.problem = MeasurementProblem::long_line, .line = line};
    case RowProblem::no_rows: break;
  }
  return {.problem = MeasurementProblem::no_rows};
}

}  // namespace

std::variant<NumberTable, BadMeasurement> read_number_table(recordings::ByteSource source) {
  recordings::NumberRows rows(std::move(source));
  auto const width = rows.names().size();
  NumberTable table{.names = rows.names(), .columns = std::vector<std::vector<double>>(width), .lines = {}};
  std::vector<double> row(width);
  for (;;) {
    auto const step = rows.next(row);
    if (step == recordings::NumberRows::Step::bad) return bad_row(rows);
    if (step == recordings::NumberRows::Step::end) break;
    for (std::size_t i = 0; i < width; ++i) table.columns[i].push_back(row[i]);
    table.lines.push_back(static_cast<std::size_t>(rows.line()));
  }
  if (table.lines.size() < 2) return BadMeasurement{.problem = MeasurementProblem::no_rows};
  return table;
}

}  // namespace axisc::tuning
