// What a scope recorded, with any bytes: it is refused, or compared with figures that are numbers.
#include "axisc/environment/failure.hpp"
#include "axisc/files/recorded_columns.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using namespace axisc;

constexpr design::CycleTime cycle_time{1'000'000};

void require(bool condition) {
  if (!condition) std::abort();
}

comparison::Configured configured(bool with_kernel) {
  comparison::Configured made{.cycle_time = cycle_time, .filters = {}, .kernel = {}};
  if (with_kernel) {
    made.kernel = design::KernelSpecification{.type = design::KernelType::moving_average, .order = 8};
  } else {
    made.filters.push_back({.type = design::FilterType::lowpass,
                            .prototype = design::Prototype::butterworth,
                            .order = 2,
                            .frequency = {80}});
  }
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  try {
    auto const file = read_recording_file("scope.csv", recordings::source_of(bytes));
    auto const recorded = read_recorded_columns(file, {}, {}, cycle_time);
    auto const& recording = recorded.recording;
    require(recording.input.size() == recording.output.size());
    for (auto const gap : recording.gaps) require(gap < recording.input.size());
    auto const told = comparison::compare(recording, comparison::readings(configured(size % 2 == 0)));
    require(!(told.listed.rms < 0) && told.compared <= recording.input.size());
    for (auto const& one : told.fitting) require(std::isfinite(one.residual.rms));
  } catch (Failure const&) {
    return 0;
  }
  return 0;
}
