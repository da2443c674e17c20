#include "analysis/motion/program/dynamics/block_weights.hpp"

#include <memory>

namespace axisc::motion {

using schema::Weighting;

namespace {

/// P-CHAN-00001: 0 all, 1 up, 2 down.
void weigh_acceleration(AxisWeights& weights, double percent, std::uint8_t which) {
  if (which != 2) weights.up.acceleration = percent;
  if (which != 1) weights.down.acceleration = percent;
}

/// P-CHAN-00073: 0 all, 1 and 2 up, 3 and 4 down, build up before take back.
void weigh_ramp_times(AxisWeights& weights, double percent, std::uint8_t which) {
  if (which == 0 || which == 1) weights.up.build_up = percent;
  if (which == 0 || which == 2) weights.up.take_back = percent;
  if (which == 0 || which == 3) weights.down.build_up = percent;
  if (which == 0 || which == 4) weights.down.take_back = percent;
}

void weigh(AxisWeights& weights, Weighting::Of of, double percent, std::uint8_t acceleration,
           std::uint8_t ramp) {
  switch (of) {
    case Weighting::Of::velocity: weights.velocity = percent; return;
    case Weighting::Of::acceleration: return weigh_acceleration(weights, percent, acceleration);
    case Weighting::Of::ramp_times: return weigh_ramp_times(weights, percent, ramp);
    case Weighting::Of::curve_ramp_time: weights.curve_ramp = percent; return;
    case Weighting::Of::feedforward: return;
  }
}

}  // namespace

BlockDynamics dynamics_of(machine::ChannelDynamics const& channel) {
  BlockDynamics dynamics;
  dynamics.slope = channel.slope;
  dynamics.constant_ramp_times = channel.constant_ramp_times;
  return dynamics;
}

void change_dynamics(ModalWords& modal, machine::ChannelDynamics const& channel,
                     std::function<void(BlockDynamics&)> const& change) {
  auto changed = std::make_shared<BlockDynamics>(modal.dynamics ? *modal.dynamics : dynamics_of(channel));
  change(*changed);
  modal.dynamics = std::move(changed);
}

void weigh_axis(BlockDynamics& dynamics, ModalWords const& modal, Weighting const& weighting,
                std::size_t axis, double percent) {
  using In = Weighting::In;
  if (weighting.in == In::feed || weighting.in == In::all) {
    weigh(dynamics.feed.at(axis), weighting.of, percent, modal.weighted_acceleration, modal.weighted_ramp);
  }
  if (weighting.in == In::rapid || weighting.in == In::all) {
    weigh(dynamics.rapid.at(axis), weighting.of, percent, 0, 0);
  }
}

}  // namespace axisc::motion
