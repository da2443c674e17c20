#include "axisc/files/recorded_columns.hpp"

#include <array>
#include <utility>

namespace axisc {

RecordedColumns read_recorded_columns(RecordingFile const& file, AxisPlace const& axis,
                                      WantedColumns const& wanted, design::CycleTime cycle_time) {
  using recordings::Object;
  auto const chosen =
      choose_columns(file, axis,
                     {{.object = Object::position_unfiltered, .option = "--in", .column = wanted.input},
                      {.object = Object::position_filtered, .option = "--out", .column = wanted.output}});
  constexpr double microseconds = 1000;
  std::array const channels{chosen[0].channel, chosen[1].channel};
  auto joined = cycles_of(file, channels, cycle_time.microseconds() / microseconds);
  return {.input_name = file.recording.channels[channels[0]].name,
          .output_name = file.recording.channels[channels[1]].name,
          .input = chosen[0],
          .output = chosen[1],
          .recording = {.input = std::move(joined.signals[0]),
                        .output = std::move(joined.signals[1]),
                        .gaps = std::move(joined.gaps)},
          .repeated = joined.repeated};
}

}  // namespace axisc
