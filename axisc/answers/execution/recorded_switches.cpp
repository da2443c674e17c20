#include "axisc/answers/execution/recorded_switches.hpp"

#include "axisc/environment/failure.hpp"

#include <algorithm>
#include <limits>

namespace axisc::says {

constexpr Sentence nothing_to_switch{
    "axis {axis} of {file} has no FIR or HSC filter or guard that \"{command}\" could switch",
    "Achse {axis} in {file} hat keinen FIR- oder HSC-Filter oder Vibration Guard, den \"{command}\" "
    "schalten könnte"};
constexpr Sentence still_changing{
    "\"{command}\" at cycle {cycle}: the filter is still changing over from the previous command, until "
    "cycle {end}",
    "\"{command}\" in Zyklus {cycle}: der Filter ist noch im Übergang vom vorherigen Befehl, bis Zyklus "
    "{end}"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// No recording has more cycles than a size can count.
std::size_t to_size(std::uint64_t cycle) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(cycle, std::numeric_limits<std::size_t>::max()));
}

}  // namespace

std::vector<comparison::KernelSwitch> kernel_switches(std::vector<TimedCommand> const& commands,
                                                      image::ImageContents const& image, std::size_t axis,
                                                      std::string const& path) {
  std::vector<comparison::KernelSwitch> switches;
  auto const& slot = image.axes[axis].slot;
  bool on = slot && slot->on_at_start;
  for (auto const& command : commands) {
    if (!slot || !slot->group) {
      throw Failure({says::nothing_to_switch,
                     {{"axis", axis_label(image, axis)}, {"file", path}, {"command", command.text}}});
    }
    auto const end = switches.empty() ? 0 : switches.back().cycle + switches.back().fade_cycles;
    if (command.cycle < end) {
      throw Failure({says::still_changing,
                     {{"command", command.text},
                      {"cycle", std::to_string(command.cycle)},
                      {"end", std::to_string(end)}}});
    }
    if (!command.command.reaches(slot->family)) continue;
    auto const& group = image.groups[*slot->group];
    auto const wanted = command.command.filter_switch;
    if (wanted != machine::FilterSwitch::unchanged) on = wanted == machine::FilterSwitch::on;
    comparison::KernelSwitch one{
        .cycle = to_size(command.cycle), .kernel = {}, .fade_cycles = group.off_fade_cycles};
    if (on) {
      auto const& bank = bank_of(command, group, image, path);
      auto const member = std::find(group.members.begin(), group.members.end(), axis) - group.members.begin();
      auto const kernel = bank.kernels[static_cast<std::size_t>(member)];
      if (kernel) one.kernel = image.kernels[*kernel].specification;
      one.fade_cycles = bank.fade_cycles;
    }
    switches.push_back(one);
  }
  return switches;
}

}  // namespace axisc
