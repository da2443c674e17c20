// The channel that runs a program: its axes, and how it reads #FILTER commands.
#pragma once

#include "configuration/machine/filter_command.hpp"
#include "configuration/machine/path_dynamics.hpp"
#include "diagnostics/finding.hpp"
#include "grammar/nc_command.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::motion {

/// The meaning of a #FILTER command, or its mistakes. Spans count like those of the command.
struct FilterCommandReading {
  struct Mistake {
    Code code{};
    Span span;
    Message message;
  };
  std::optional<machine::FilterCommand> command;
  std::vector<Mistake> mistakes;
};

/// Reads a command, whose spans count from the start of the text.
using FilterCommandReader = std::function<FilterCommandReading(grammar::NcCommand const&, std::string_view)>;

struct ProgramChannel {
  std::vector<std::string> axes;
  std::vector<bool> rotary;  ///< lengths of these are degrees, whatever the program's unit
  bool inch = false;         ///< unless the program says otherwise
  design::CycleTime cycle_time;
  FilterCommandReader read_filter_command;
  machine::ChannelDynamics dynamics = {};
  bool sharp_corners = false;  ///< corners that the control rounds are followed as they are
  /// Blocks of loops and subprograms that are executed at most: an endless loop ends there.
  std::uint64_t most_repeated_blocks = 10'000'000;

  /// The axis of that name.
  [[nodiscard]] std::optional<std::size_t> axis(std::string_view name) const;
  /// The first axis whose name begins like this: X1 is the X of a circle.
  [[nodiscard]] std::optional<std::size_t> axis_beginning_with(char letter) const;
};

}  // namespace axisc::motion
