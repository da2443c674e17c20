#include "cli/plots/measured_response.hpp"

#include "cli/failure.hpp"
#include "cli/files/byte_source.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace axisc::cli::says {

constexpr Sentence measured_columns{
    "{file} has no column {column}; a measured response has frequency_hz, magnitude_db and possibly "
    "phase_deg",
    "{file} hat keine Spalte {column}; ein gemessener Frequenzgang hat frequency_hz, magnitude_db und "
    "vielleicht "
    "phase_deg"};
constexpr Sentence measured_nothing{"{file} has no frequency above 0 with a finite magnitude",
                                    "{file} hat keine Frequenz über 0 mit einem endlichen Betrag"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

std::optional<std::size_t> column(CsvReader const& reader, std::string_view name) {
  auto const& header = reader.header();
  auto const found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

std::size_t required_column(CsvReader const& reader, std::string const& path, std::string_view name) {
  if (auto const found = column(reader, name)) return *found;
  throw Failure(
      {.sentence = says::measured_columns, .arguments = {{"file", path}, {"column", std::string(name)}}});
}

}  // namespace

std::vector<MeasuredPoint> read_measured_response(std::string const& path) {
  CsvReader reader(path, open_source(path));
  auto const frequency = required_column(reader, path, "frequency_hz");
  auto const magnitude = required_column(reader, path, "magnitude_db");
  auto const phase = column(reader, "phase_deg");
  std::vector<MeasuredPoint> points;
  std::vector<double> row(reader.header().size());
  while (reader.next(row)) {
    if (!(row[frequency] > 0) || !std::isfinite(row[frequency]) || !std::isfinite(row[magnitude])) continue;
    points.push_back(
        {.frequency = row[frequency],
         .magnitude_db = row[magnitude],
         .phase_deg = phase && std::isfinite(row[*phase]) ? std::optional(row[*phase]) : std::nullopt});
  }
  if (points.empty()) throw Failure({.sentence = says::measured_nothing, .arguments = {{"file", path}}});
  std::stable_sort(points.begin(), points.end(),
                   [](MeasuredPoint const& a, MeasuredPoint const& b) { return a.frequency < b.frequency; });
  return points;
}

}  // namespace axisc::cli
