// Executes an image for `axisc run`: setpoints in, filtered setpoints out, commands in between.
#pragma once

#include "axisc/answers/execution/stimulus.hpp"
#include "axisc/answers/execution/timed_commands.hpp"
#include "image/runtime_host.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Cycles with the same event: how many, and the first one.
struct Occurrences {
  std::uint64_t count = 0;
  std::uint64_t first_cycle = 0;
  void add(std::uint64_t cycle) {
    if (count++ == 0) first_cycle = cycle;
  }
};

/// Events that the runtime reported without stopping.
struct Noticed {
  Occurrences refused;  ///< inputs that were not accepted; it went on with the last good one
  Occurrences jumps;    ///< outputs that moved farther than their axis may
};

/// How the table of a run is written.
struct RunTable {
  bool has_time = false;  ///< a first column with the time since the first cycle, in seconds
  bool is_text = false;   ///< aligned columns with four significant digits instead of CSV
};

class Execution {
 public:
  /// `path` is the image's file in messages.
  Execution(std::string path, image::RuntimeHost host, image::ImageContents const& image, Stimulus& stimulus,
            std::vector<TimedCommand> commands);

  /// Records the last cycles from now on. Failure if that is not possible.
  void record(std::uint32_t cycles);
  [[nodiscard]] std::vector<std::byte> recording() const { return host_.recording(); }

  /// Resets all axes: to `position` at the port that the stimulus feeds, to 0 elsewhere.
  void reset(double position, Port fed);
  /// Runs to the end of the stimulus and passes on the table in pieces, header first. Failure if the runtime
  /// stops or a command cannot be executed.
  Noticed go(RunTable table, std::function<void(std::string_view)> const& write);

 private:
  /// A column of output.
  struct Output {
    std::string name;
    std::vector<double> const* values = nullptr;  ///< of all axes
    std::size_t axis = 0;
  };
  [[nodiscard]] std::vector<Output> outputs() const;
  [[nodiscard]] std::vector<double>& in(Input input) { return in_[static_cast<std::size_t>(input)]; }
  void execute_commands(std::uint64_t cycle);
  void feed(std::vector<double> const& row);
  void step(std::uint64_t cycle, Noticed& noticed);
  void notice(axisrt_status worst, std::uint64_t cycle, Noticed& noticed) const;

  std::string path_;
  image::RuntimeHost host_;
  image::ImageContents const& image_;
  Stimulus& stimulus_;
  std::vector<TimedCommand> commands_;  ///< by rising cycle
  std::size_t next_command_ = 0;
  std::vector<bool> has_v_direct_;  ///< axes whose direct velocity is fed; the others' is the motor's
  bool feeds_velocities_ = false;
  std::array<std::vector<double>, inputs> in_;
  std::vector<double> setpoints_, interface_, v_add_, increments_;
  std::vector<std::uint8_t> status_;  ///< of all axes, of the latest call
};

}  // namespace axisc
