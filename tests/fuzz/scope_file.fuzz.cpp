// A recording with any bytes, text or binary: it is refused, or its channels have a value for each sample.
#include "analysis/recordings/cycles.hpp"
#include "analysis/recordings/objects.hpp"
#include "analysis/recordings/recording_reader.hpp"
#include "analysis/recordings/scaling.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

namespace {

using namespace axisc::recordings;

void require(bool condition) {
  if (!condition) std::abort();
}

void check(Recording const& recording) {
  for (auto const& clock : recording.clocks) {
    require(clock.is_counted || clock.times.size() == clock.samples);
    double last = -HUGE_VAL;
    for (double const time : clock.times.values()) {
      require(time > last);
      last = time;
    }
  }
  for (auto const& channel : recording.channels) {
    require(channel.clock < recording.clocks.size());
    require(channel.values.size() == recording.clocks[channel.clock].samples);
    static_cast<void>(object_of(channel));
    static_cast<void>(scaling_of(channel));
  }
}

void check_cycles(Recording const& recording, double cycle_ms) {
  std::array const channels{std::size_t{0}, recording.channels.size() - 1};
  auto const joined = by_cycles(recording, channels, cycle_ms);
  auto const* const found = std::get_if<CycleSignals>(&joined);
  if (found == nullptr) return;
  require(found->signals[0].size() == found->signals[1].size());
  for (auto const gap : found->gaps) require(gap < found->signals[0].size());
  for (double const value : found->signals[1].values()) require(std::isfinite(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  auto const read = read_recording(source_of(bytes));
  auto const* const recording = std::get_if<Recording>(&read);
  if (recording == nullptr) return 0;
  check(*recording);
  if (recording->channels.empty()) return 0;
  check_cycles(*recording, 1);
  check_cycles(*recording, sample_time(recording->clocks[recording->channels.front().clock]));
  return 0;
}
