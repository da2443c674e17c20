#include "analysis/tuning/identification/measurement.hpp"

#include "analysis/tuning/identification/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace axisc::tuning {
namespace {

constexpr double lowest_frequency = 2;
constexpr double highest_share = 0.4;  ///< of the sampling rate
constexpr double lowest_bins = 4;
/// Times are rounded when they are written.
constexpr double even_within = 0.5;

using Column = std::optional<std::size_t>;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char byte) {
    return byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
  });
  return text;
}

Column beginning_with(NumberTable const& table, std::initializer_list<std::string_view> words) {
  for (auto const word : words) {
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      if (lower(table.names[i]).starts_with(word)) return i;
    }
  }
  return std::nullopt;
}

Column named(NumberTable const& table, std::string const& name) {
  auto const found = std::find(table.names.begin(), table.names.end(), name);
  return found == table.names.end() ? Column() : Column(found - table.names.begin());
}

using Result = std::variant<Measurement, BadMeasurement>;

Result response_of(NumberTable const& table, std::size_t frequency) {
  auto const decibels = beginning_with(table, {"magnitude_db"});
  auto const magnitude = beginning_with(table, {"magnitude", "amplitude"});
  auto const power = beginning_with(table, {"psd"});
  auto const phase = beginning_with(table, {"phase_deg"});
  auto const coherence = beginning_with(table, {"coherence"});
  if (!decibels && !magnitude && !power) return BadMeasurement{.problem = MeasurementProblem::no_columns};
  Measurement found{.kind = phase ? MeasurementKind::response : MeasurementKind::spectrum};
  found.response.has_phase = phase.has_value();
  constexpr double degree = 0.017453292519943295;
  constexpr double bel = 20;
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    double const f = table.columns[frequency][row];
    if (!found.response.frequency.empty() && !(f > found.response.frequency.back())) {
      return BadMeasurement{.problem = MeasurementProblem::uneven_frequency, .line = table.lines[row]};
    }
    if (!(f > 0)) continue;
    double height = 0;
    if (decibels) {
      height = std::pow(10, std::clamp(table.columns[*decibels][row], -600.0, 600.0) / bel);
    } else {
      height = magnitude ? std::abs(table.columns[*magnitude][row])
                         : std::sqrt(std::abs(table.columns[*power][row]));
    }
    found.response.frequency.push_back(f);
    found.response.response.push_back(
        phase ? std::polar(height, std::remainder(table.columns[*phase][row], 360.0) * degree) : height);
    if (coherence) found.response.coherence.push_back(table.columns[*coherence][row]);
  }
  return found;
}

/// All columns that do not hold times; a column that repeats the times is left out, too.
std::vector<std::size_t> signal_columns(NumberTable const& table, std::size_t time) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i != time && table.names[i] != table.names[time] && table.columns[i] != table.columns[time]) {
      found.push_back(i);
    }
  }
  return found;
}

std::optional<BadMeasurement> set_rate(Measurement& found, NumberTable const& table, std::size_t time) {
  auto const& times = table.columns[time];
  auto const steps = static_cast<double>(times.size() - 1);
  double const step = (times.back() - times.front()) / steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    double const here = times[i] - times[i - 1];
    if (!(step > 0) || !(std::abs(here - step) <= even_within * step)) {
      return BadMeasurement{.problem = MeasurementProblem::uneven_time, .line = table.lines[i]};
    }
  }
  bool const in_milliseconds = lower(table.names[time]).find("ms") != std::string::npos;
  constexpr double milli = 1e-3;
  found.sampling_rate = 1 / (step * (in_milliseconds ? milli : 1));
  return std::nullopt;
}

Result signals_of(NumberTable const& table, std::size_t time, SignalColumns const& wanted) {
  auto const others = signal_columns(table, time);
  Column in, out;
  for (auto const& [name, column] : {std::pair(&wanted.in, &in), {&wanted.out, &out}}) {
    if (!*name) continue;
    *column = named(table, **name);
    if (!*column) return BadMeasurement{.problem = MeasurementProblem::unknown_column, .column = **name};
  }
  if (!in && !out && others.size() == 2) {
    in = others[0];
    out = others[1];
  }
  if (!in || !out) {
    std::string names;
    for (auto const other : others) names += (names.empty() ? "" : ", ") + table.names[other];
    return BadMeasurement{.problem = MeasurementProblem::choose_columns, .column = names};
  }
  Measurement found{.kind = MeasurementKind::signals};
  if (auto bad = set_rate(found, table, time)) return *std::move(bad);
  found.in = table.columns[*in];
  found.out = table.columns[*out];
  found.in_name = table.names[*in];
  found.out_name = table.names[*out];
  return found;
}

}  // namespace

Result read_measurement(recordings::ByteSource source, SignalColumns const& columns) {
  auto read = read_number_table(std::move(source));
  if (auto* const bad = std::get_if<BadMeasurement>(&read)) return std::move(*bad);
  auto const& table = std::get<NumberTable>(read);
  if (auto const frequency = beginning_with(table, {"freq"})) return response_of(table, *frequency);
  if (auto const time = beginning_with(table, {"time", "zeit"})) return signals_of(table, *time, columns);
  return BadMeasurement{.problem = MeasurementProblem::no_columns};
}

Identification identify(Measurement const& measurement, double highest) {
  if (measurement.kind != MeasurementKind::signals) {
    auto const lowest = std::max(lowest_frequency, lowest_bins * measurement.response.resolution());
    return identify(measurement.response, lowest, highest);
  }
  auto const count = static_cast<double>(measurement.in.size());
  // The parts that are compared have a sixteenth of the whole's resolution.
  constexpr double parts = 16;
  auto const lowest =
      std::max(lowest_frequency, lowest_bins * parts * measurement.sampling_rate / std::max(1.0, count));
  return identify(measurement.in, measurement.out, measurement.sampling_rate, lowest,
                  std::min(highest, highest_share * measurement.sampling_rate));
}

}  // namespace axisc::tuning
