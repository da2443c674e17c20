#include "analysis/motion/group_runtime.hpp"

#include <algorithm>
#include <utility>

namespace axisc::motion {

std::variant<GroupRuntime, axisrt_status> GroupRuntime::create(std::span<std::byte const> image,
                                                               image::ImageContents const& contents,
                                                               std::vector<std::size_t> axes) {
  auto host = image::RuntimeHost::create(image);
  if (auto const* const status = std::get_if<axisrt_status>(&host)) return *status;
  GroupRuntime group(std::get<image::RuntimeHost>(std::move(host)), std::move(axes));
  for (std::uint32_t i = 0; i < contents.groups.size(); ++i) {
    auto const& members = contents.groups[i].members;
    if (std::find_first_of(members.begin(), members.end(), group.axes_.begin(), group.axes_.end()) !=
        members.end()) {
      group.image_groups_.push_back(i);
    }
  }
  group.in_.assign(group.host_.axis_count(), 0);
  group.out_ = group.in_;
  return group;
}

void GroupRuntime::delay(std::vector<machine::PositionDelay> const& at_start,
                         std::vector<machine::PositionDelay> const& fed_forward) {
  at_start_ = unequal_delays(at_start);
  fed_forward_ = unequal_delays(fed_forward);
  feed_forward(false);
}

axisrt_status GroupRuntime::reset(Point const& position) {
  axisrt_status worst = host_.reset_all(0);
  delays_.reset(position);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    worst = std::max(worst, host_.reset(static_cast<std::uint32_t>(axes_[i]), position[i]));
  }
  return worst;
}

axisrt_status GroupRuntime::command(machine::FilterCommand const& command) {
  axisrt_status worst = AXISRT_OK;
  for (auto const group : image_groups_) worst = std::max(worst, host_.command(group, command));
  return worst;
}

axisrt_status GroupRuntime::step(Point const& setpoint, Point& filtered) {
  for (std::size_t i = 0; i < axes_.size(); ++i) in_[axes_[i]] = setpoint[i];
  axisrt_status const status = host_.step(in_, out_);
  for (std::size_t i = 0; i < axes_.size(); ++i) filtered[i] = out_[axes_[i]];
  delays_.step(filtered);
  return status;
}

}  // namespace axisc::motion
