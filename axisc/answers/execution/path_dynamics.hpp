// What the lists of a machine say about how fast its paths may be driven, with the readings of its settings.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "configuration/machine/machine.hpp"
#include "presentation/value.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace axisc {

/// The first channel that moves the axis, of a gantry slave its master; none for a spindle, say.
[[nodiscard]] std::optional<std::size_t> channel_of_axis(machine::Machine const& machine, std::size_t axis);

/// A path of a channel.
[[nodiscard]] motion::PathDynamics path_dynamics(machine::Machine const& machine,
                                                 machine::MachineGroup const& group);

/// The axis alone, with the slope of its channel; without a channel with the control's defaults. A gantry
/// slave moves as its master.
[[nodiscard]] motion::PathDynamics path_dynamics(machine::Machine const& machine, std::size_t axis);

/// As NC programs write it: "TRAPEZ".
[[nodiscard]] std::string_view slope_name(machine::Slope slope);

/// "slope TRAPEZ, as the channel list says".
[[nodiscard]] presentation::Words slope_words(machine::ChannelDynamics const& channel);

}  // namespace axisc
