// The runtime as one NC channel sees it: its axes in the order of the path, and its filters to switch.
#pragma once

#include "analysis/motion/contour/position_delays.hpp"
#include "analysis/motion/point.hpp"
#include "axisrt.h"
#include "configuration/machine/filter_command.hpp"
#include "configuration/machine/machine.hpp"
#include "image/image_contents.hpp"
#include "image/runtime_host.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::motion {

class GroupRuntime {
 public:
  /// `image` is one that read_image() accepted; `axes` are its axes in the order of the path, at most
  /// most_axes.
  [[nodiscard]] static std::variant<GroupRuntime, axisrt_status> create(std::span<std::byte const> image,
                                                                        image::ImageContents const& contents,
                                                                        std::vector<std::size_t> axes);

  [[nodiscard]] std::size_t axis_count() const { return axes_.size(); }

  /// The positions are delayed after the filters, too: one for each axis, at the start of programs and after
  /// G135. In force from now on are those of the start.
  void delay(std::vector<machine::PositionDelay> const& at_start,
             std::vector<machine::PositionDelay> const& fed_forward);
  /// G135 and G137 change which axis arrives when.
  [[nodiscard]] bool feedforward_matters() const { return at_start_ != fed_forward_; }
  /// G135 or G137. Needs a reset().
  void feed_forward(bool is_on) { delays_ = PositionDelays(is_on ? fed_forward_ : at_start_); }

  /// Every axis rests at `position`.
  [[nodiscard]] axisrt_status reset(Point const& position);
  /// Executes #FILTER for the channel; AXISRT_OK where it has no filter to switch.
  [[nodiscard]] axisrt_status command(machine::FilterCommand const& command);
  /// One NC cycle.
  [[nodiscard]] axisrt_status step(Point const& setpoint, Point& filtered);

 private:
  GroupRuntime(image::RuntimeHost host, std::vector<std::size_t> axes)
      : host_(std::move(host)), axes_(std::move(axes)) {}

  image::RuntimeHost host_;
  std::vector<std::size_t> axes_;                               ///< of the image
  std::vector<std::uint32_t> image_groups_;                     ///< that hold an axis of ours
  std::vector<double> in_, out_;                                ///< all axes of the image
  std::vector<machine::PositionDelay> at_start_, fed_forward_;  ///< as unequal_delays() leaves them
  PositionDelays delays_;
};

}  // namespace axisc::motion
