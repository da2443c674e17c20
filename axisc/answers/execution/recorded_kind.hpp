// What the name and the unit of a recorded column say of it.
#pragma once

#include "analysis/recordings/recording.hpp"
#include "analysis/tuning/identification/motion_pieces.hpp"
#include "axisc/files/recorded_choice.hpp"

#include <string>

namespace axisc {

/// By the object that it is, else by its name and unit. What says nothing is a position.
[[nodiscard]] tuning::InputKind kind_of(recordings::Channel const& channel, ChosenColumn const& column);

/// In brackets behind the name, else the channel's; empty where neither names one.
[[nodiscard]] std::string named_unit(recordings::Channel const& channel);

}  // namespace axisc
