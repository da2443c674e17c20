#include "analysis/tuning/identification/measurement.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace axisc::tuning {
namespace {

constexpr double lowest_bins = 4;

using recordings::Channel;
using recordings::Recording;

/// The first word that a column begins with, whatever its case; null where there is none.
Channel const* beginning_with(Recording const& recording, std::initializer_list<std::string_view> words) {
  for (auto const word : words) {
    for (auto const& channel : recording.channels) {
      if (ascii::lower_case(channel.name).starts_with(word)) return &channel;
    }
  }
  return nullptr;
}

/// The first field that is not a number, in a column that is read.
std::optional<BadMeasurement> bad_field(std::initializer_list<Channel const*> channels) {
  std::optional<BadMeasurement> bad;
  for (auto const* const channel : channels) {
    if (channel == nullptr || !channel->bad || (bad && bad->line <= channel->bad->line)) continue;
    bad = BadMeasurement{.problem = MeasurementProblem::not_a_number, .line = channel->bad->line};
  }
  return bad;
}

}  // namespace

bool is_response(Recording const& recording) {
  return recording.form == recordings::Form::columns && recording.clocks.front().is_counted &&
         beginning_with(recording, {"freq"}) != nullptr;
}

std::variant<Measurement, BadMeasurement> response_measurement(Recording const& recording) {
  auto const* const frequency = beginning_with(recording, {"freq"});
  auto const* const decibels = beginning_with(recording, {"magnitude_db"});
  auto const* const magnitude = beginning_with(recording, {"magnitude", "amplitude"});
  auto const* const power = beginning_with(recording, {"psd"});
  auto const* const phase = beginning_with(recording, {"phase_deg"});
  auto const* const coherence = beginning_with(recording, {"coherence"});
  auto const* const height = decibels != nullptr ? decibels : magnitude != nullptr ? magnitude : power;
  if (height == nullptr) return BadMeasurement{.problem = MeasurementProblem::no_columns};
  if (auto bad = bad_field({frequency, height, phase, coherence})) return *bad;
  auto const& clock = recording.clocks[frequency->clock];
  if (clock.samples < 2) return BadMeasurement{.problem = MeasurementProblem::too_short};
  bool const has_phase = phase != nullptr;
  Measurement found{.kind = has_phase ? MeasurementKind::response : MeasurementKind::spectrum};
  found.response.has_phase = has_phase;
  constexpr double degree = 0.017453292519943295;
  constexpr double bel = 20;
  double last = 0;
  for (std::size_t row = 0; row < clock.samples; ++row) {
    auto const bad = [&](MeasurementProblem problem) {
      return BadMeasurement{.problem = problem, .line = static_cast<std::uint64_t>(clock.lines.at(row))};
    };
    double const f = frequency->values.at(row);
    double const value = height->values.at(row);
    if (std::isnan(f) || std::isnan(value)) return bad(MeasurementProblem::not_a_number);
    if (!found.response.frequency.empty() && !(f > last)) return bad(MeasurementProblem::uneven_frequency);
    last = f;
    if (!(f > 0)) continue;
    double const size = decibels != nullptr    ? std::pow(10, std::clamp(value, -600.0, 600.0) / bel)
                        : magnitude != nullptr ? std::abs(value)
                                               : std::sqrt(std::abs(value));
    double const angle = has_phase ? std::remainder(phase->values.at(row), 360.0) * degree : 0;
    if (std::isnan(angle)) return bad(MeasurementProblem::not_a_number);
    found.response.frequency.push_back(f);
    found.response.response.push_back(has_phase ? std::polar(size, angle) : size);
    if (coherence != nullptr) found.response.coherence.push_back(coherence->values.at(row));
  }
  return found;
}

Identification identify(Measurement const& measurement, double highest) {
  Identification found;
  double lowest = lowest_frequency;
  if (measurement.kind != MeasurementKind::signals) {
    lowest = std::max(lowest, lowest_bins * measurement.response.resolution());
    found = identify(measurement.response, lowest, highest);
  } else {
    auto const count = static_cast<double>(measurement.in.size());
    // Where no resonance of a simulated axis was missed (tests/analysis/tuning/mode_recordings.py).
    constexpr double parts = 16;
    lowest = std::max(lowest, lowest_bins * parts * measurement.sampling_rate / std::max(1.0, count));
    found = identify(measurement.in, measurement.out, measurement.sampling_rate, lowest,
                     std::min(highest, highest_share * measurement.sampling_rate));
  }
  found.lowest = lowest;
  return found;
}

}  // namespace axisc::tuning
