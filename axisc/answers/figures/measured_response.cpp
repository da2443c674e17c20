#include "axisc/answers/figures/measured_response.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"
#include "axisc/files/row_problem.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace axisc::says {

constexpr Sentence measured_columns{
    "{file} has no column {column}; a measured response has frequency_hz, magnitude_db and possibly "
    "phase_deg",
    "{file} hat keine Spalte {column}; ein gemessener Frequenzgang hat frequency_hz, magnitude_db und "
    "vielleicht phase_deg"};
constexpr Sentence measured_nothing{"{file} has no frequency above 0 with a finite magnitude",
                                    "{file} hat keine Frequenz über 0 mit einem endlichen Betrag"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::optional<std::size_t> column(recordings::NumberRows const& rows, std::string_view name) {
  auto const& names = rows.names();
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::size_t required_column(recordings::NumberRows const& rows, std::string const& path,
                            std::string_view name) {
  if (auto const found = column(rows, name)) return *found;
  throw Failure({says::measured_columns, {{"file", path}, {"column", std::string(name)}}});
}

}  // namespace

std::vector<MeasuredPoint> read_measured_response(std::string const& path) {
  recordings::NumberRows rows(open_source(path), recordings::Accepts::any);
  if (rows.problem()) fail_row(rows, path);
  auto const frequency = required_column(rows, path, "frequency_hz");
  auto const magnitude = required_column(rows, path, "magnitude_db");
  auto const phase = column(rows, "phase_deg");
  std::vector<std::size_t> columns{frequency, magnitude};
  if (phase) columns.push_back(*phase);
  rows.read_only(columns);
  std::vector<MeasuredPoint> points;
  std::vector<double> row(rows.names().size());
  while (next_row(rows, row, path)) {
    if (!(row[frequency] > 0) || !std::isfinite(row[frequency]) || !std::isfinite(row[magnitude])) continue;
    points.push_back(
        {.frequency = row[frequency],
         .magnitude_db = row[magnitude],
         .phase_deg = phase && std::isfinite(row[*phase]) ? std::optional(row[*phase]) : std::nullopt});
  }
  if (points.empty()) throw Failure({says::measured_nothing, {{"file", path}}});
  std::stable_sort(points.begin(), points.end(),
                   [](MeasuredPoint const& a, MeasuredPoint const& b) { return a.frequency < b.frequency; });
  return points;
}

}  // namespace axisc
