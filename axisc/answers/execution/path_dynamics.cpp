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

motion::PathDynamics path_dynamics(machine::Machine const& machine, std::size_t axis) {
  if (auto const& master = machine.axes[axis].gantry_master) return path_dynamics(machine, *master);
  auto const own = std::find_if(machine.groups.begin(), machine.groups.end(), [axis](auto const& group) {
    return std::find(group.axes.begin(), group.axes.end(), axis) != group.axes.end();
  });
  return dynamics_of(machine, own != machine.groups.end() ? own->dynamics : machine::ChannelDynamics(),
                     {axis});
}

std::string_view slope_name(machine::Slope slope) {
  return machine::slope_names.at(static_cast<std::size_t>(slope));
}

presentation::Words slope_words(machine::ChannelDynamics const& channel) {
  return {channel.is_from_list ? SentenceRef(says::slope_of_channel_list) : says::slope_of_control,
          {{"slope", slope_name(channel.slope)}}};
}

}  // namespace axisc
