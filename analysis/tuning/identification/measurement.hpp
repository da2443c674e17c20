// A measurement of an axis: two signals over time, a frequency response, or a spectrum.
//
//   response    columns "frequency_hz" or "freq", "magnitude_db" or "magnitude", "phase_deg", perhaps
//               "coherence" (0 to 1)
//   spectrum    columns "frequency_hz" or "freq", "magnitude_db", "magnitude" or "psd…"
#pragma once

#include "analysis/recordings/recording.hpp"
#include "analysis/tuning/identification/motion_pieces.hpp"
#include "analysis/tuning/identification/resonances.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc::tuning {

enum class MeasurementKind : std::uint8_t { signals, response, spectrum };

struct Measurement {
  MeasurementKind kind = MeasurementKind::spectrum;
  MeasuredResponse response{};            ///< unless signals
  std::vector<double> in{}, out{};        ///< of signals
  double sampling_rate = 0;               ///< of signals, Hz
  InputKind input = InputKind::position;  ///< of signals
};

enum class MeasurementProblem : std::uint8_t {
  no_columns,        ///< a frequency without a magnitude
  too_short,         ///< not two rows
  not_a_number,      ///< `line`
  uneven_frequency,  ///< `line`: frequencies do not rise
};

struct BadMeasurement {
  MeasurementProblem problem = MeasurementProblem::no_columns;
  std::uint64_t line = 0;  ///< from 1
};

/// Its columns have frequencies, not times.
[[nodiscard]] bool is_response(recordings::Recording const& recording);

/// Of a recording that is_response().
[[nodiscard]] std::variant<Measurement, BadMeasurement> response_measurement(
    recordings::Recording const& recording);

/// Resonances between 2 Hz, or four times the resolution, and `highest`, or 0.4 of the sampling rate.
[[nodiscard]] Identification identify(Measurement const& measurement, double highest);

}  // namespace axisc::tuning
