#include "axisc/answers/execution/path_dynamics.hpp"

#include <algorithm>
#include <vector>

namespace axisc::says {

constexpr Sentence slope_of_channel_list{"slope {slope}, as the channel list says",
                                         "Slope {slope} nach der Kanalliste"};
constexpr Sentence slope_of_control{
    "slope {slope}, the control's default, as no channel list is named",
    "Slope {slope}, der Standardwert der Steuerung, weil keine Kanalliste genannt ist"};

}  // namespace axisc::says

namespace axisc {

namespace {

motion::PathDynamics dynamics_of(machine::Machine const& machine, machine::ChannelDynamics const& channel,
                                 std::vector<std::size_t> const& axes) {
  motion::PathDynamics dynamics{
      .axes = {}, .channel = channel, .readings = machine.motion, .cycle_time = machine.cycle_time};
  for (auto const index : axes) dynamics.axes.push_back(machine.axes[index].dynamics);
  return dynamics;
}

}  // namespace

motion::PathDynamics path_dynamics(machine::Machine const& machine, machine::MachineGroup const& group) {
  return dynamics_of(machine, group.dynamics, group.axes);
}

std::optional<std::size_t> channel_of_axis(machine::Machine const& machine, std::size_t axis) {
  auto const leading = machine.axes[axis].gantry_master.value_or(axis);
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& axes = machine.groups[i].axes;
    if (std::find(axes.begin(), axes.end(), leading) != axes.end()) return i;
  }
  return std::nullopt;
}

motion::PathDynamics path_dynamics(machine::Machine const& machine, std::size_t axis) {
  auto const channel = channel_of_axis(machine, axis);
  return dynamics_of(machine, channel ? machine.groups[*channel].dynamics : machine::ChannelDynamics(),
                     {machine.axes[axis].gantry_master.value_or(axis)});
}

std::string_view slope_name(machine::Slope slope) {
  return machine::slope_names.at(static_cast<std::size_t>(slope));
}

presentation::Words slope_words(machine::ChannelDynamics const& channel) {
  return {channel.is_from_list ? SentenceRef(says::slope_of_channel_list) : says::slope_of_control,
          {{"slope", slope_name(channel.slope)}}};
}

}  // namespace axisc
