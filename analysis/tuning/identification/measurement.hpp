// A file with a measurement: two signals over time, a frequency response, or a spectrum.
//
// Rows of numbers in columns, as analysis/recordings/number_rows.hpp reads them. TwinCAT Scope writes a
// column of times for each signal: all but the first are left out.
//
//   signals     a column of times ("time", "time_ms", "Zeit [s]"; ms if the name says so, otherwise s), and
//               two others
//   response    "frequency_hz" or "freq", "magnitude_db" or "magnitude", "phase_deg", perhaps "coherence"
//               (0 to 1)
//   spectrum    "frequency_hz" or "freq", "magnitude_db", "magnitude" or "psd…"
#pragma once

#include "analysis/recordings/text_lines.hpp"
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
  MeasuredResponse response{};      ///< unless signals
  std::vector<double> in{}, out{};  ///< of signals
  double sampling_rate = 0;         ///< of signals, Hz
  std::string in_name{}, out_name{};
};

enum class MeasurementProblem : std::uint8_t {
  no_rows,           ///< not two rows of numbers
  not_a_number,      ///< `line`
  field_count,       ///< `line`
  mixed_numbers,     ///< a column with decimal points and decimal commas: `column`
  no_columns,        ///< neither times nor frequencies: the known columns
  choose_columns,    ///< more than two signals: which are input and output
  unknown_column,    ///< `column`
  uneven_time,       ///< `line`: samples are missing, or time does not advance
  uneven_frequency,  ///< `line`: frequencies do not rise
  long_line,         ///< `line`
};

struct BadMeasurement {
  MeasurementProblem problem = MeasurementProblem::no_rows;
  std::size_t line = 0;  ///< from 1
  std::string column{};  ///< its name; of choose_columns all of them
};

/// Names of the columns with the input and the output of signals; needed where there are more than two.
struct SignalColumns {
  std::optional<std::string> in = {}, out = {};
};

[[nodiscard]] std::variant<Measurement, BadMeasurement> read_measurement(recordings::ByteSource source,
                                                                         SignalColumns const& columns);

/// Resonances between 2 Hz, or four times the resolution, and `highest`, or 0.4 of the sampling rate.
[[nodiscard]] Identification identify(Measurement const& measurement, double highest);

}  // namespace axisc::tuning
