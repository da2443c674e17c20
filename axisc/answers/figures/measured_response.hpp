// A frequency response from a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct MeasuredPoint {
  double frequency = 0;  ///< Hz
  double magnitude_db = 0;
  std::optional<double> phase_deg;
};

/// By rising frequency. The file is as analysis/recordings/text_recording.hpp says, with the columns
/// frequency_hz, magnitude_db and, where measured, phase_deg; other columns are passed over. Failure (AX9005)
/// for a mistake, AX9001 for a file that cannot be read.
[[nodiscard]] std::vector<MeasuredPoint> read_measured_response(std::string const& path);

}  // namespace axisc
