// Weights of velocities, accelerations and ramp times: G127 to G134, G230 to G233.
#pragma once

#include "analysis/motion/program/modal_words.hpp"
#include "schema/motion_words.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace axisc::motion {

/// What the lists say, as the beginning of a program has it.
[[nodiscard]] BlockDynamics dynamics_of(machine::ChannelDynamics const& channel);

/// Changes the dynamics of the blocks that follow; those that were passed on keep theirs.
void change_dynamics(ModalWords& modal, machine::ChannelDynamics const& channel,
                     std::function<void(BlockDynamics&)> const& change);

/// Weighs one axis. Which accelerations and ramp times of feed blocks this concerns is in
/// `modal.weighted_acceleration` and `modal.weighted_ramp`.
void weigh_axis(BlockDynamics& dynamics, ModalWords const& modal, schema::Weighting const& weighting,
                std::size_t axis, double percent);

}  // namespace axisc::motion
