// A file of a measuring program with any bytes: it is refused, or its peaks are numbers within the band that
// was asked for.
#include "analysis/tuning/identification/measurement.hpp"

#include "analysis/recordings/recording_reader.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace axisc::tuning;
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  auto const recording = axisc::recordings::read_recording(axisc::recordings::source_of(bytes));
  auto const* const columns = std::get_if<axisc::recordings::Recording>(&recording);
  if (columns == nullptr || !is_response(*columns)) return 0;
  auto const read = response_measurement(*columns);
  auto const* const measurement = std::get_if<Measurement>(&read);
  if (measurement == nullptr) return 0;
  auto const found = identify(*measurement, 400);
  require(found.peaks.empty() == found.doubt.has_value());
  require(found.peaks.size() <= most_peaks);
  for (auto const& peak : found.peaks) {
    require(std::isfinite(peak.frequency) && peak.frequency > 0);
    require(peak.damping > 0 && peak.damping < 1);
    require(peak.frequency_uncertainty >= 0);
  }
  return 0;
}
