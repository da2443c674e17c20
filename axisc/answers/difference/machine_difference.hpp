// What differs between two machines, or between two axes of one: axes, channels, parameters, and what that
// does.
#pragma once

#include "axisc/answers/difference/compared_machine.hpp"
#include "axisc/answers/difference/parameter_difference.hpp"
#include "image/chain_difference.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

/// How an axis is driven, with WantedMove: seconds, and mm/s or °/s.
struct AxisMotion {
  machine::Slope slope = machine::Slope::step;
  bool has_channel_list = false;  ///< false: the control's defaults count
  double at_feed_s = 0, in_rapid_s = 0, corner_velocity = 0;
  std::vector<std::string> uncomputed = {};  ///< parameters that these figures leave out: "P-AXIS-00202"

  friend bool operator==(AxisMotion const&, AxisMotion const&) = default;
};

struct MotionDifference {
  AxisMotion before, after;
};

struct AxisDifference {
  ComparedAxis const* before = nullptr;
  ComparedAxis const* after = nullptr;
  bool renamed = false;
  bool other_type = false, other_drive = false;  ///< of a machine file; the lists' are parameters
  std::vector<ParameterChange> parameters;       ///< without those that mean the same, unless wanted
  std::optional<image::ChainDifference> chain;   ///< where the setpoints are filtered otherwise
  std::optional<MotionDifference> motion;        ///< where it is driven otherwise; an image does not tell

  [[nodiscard]] bool empty() const;
};

/// A channel whose axes, spindles, couplings, programs or dynamics differ; null where it exists on one side
/// only.
struct ChannelDifference {
  ComparedChannel const* before = nullptr;
  ComparedChannel const* after = nullptr;
};

/// Programs of both sides that have the same name.
[[nodiscard]] std::vector<std::string> programs_with_other_content(ChannelDifference const& channel);

struct MachineDifference {
  ComparedMachine const& before;
  ComparedMachine const& after;
  std::vector<ComparedAxis const*> axes_removed = {}, axes_added = {};
  std::vector<ChannelDifference> channels = {};
  std::vector<ComparedGantry> gantries_before = {}, gantries_after = {};  ///< those that differ
  std::vector<AxisDifference> axes = {};                                  ///< those with a difference
  std::size_t set_to_default = 0;          ///< parameters left out: one side sets what is its default
  bool of_one_machine = false;             ///< two axes of it
  std::vector<std::string> left_out = {};  ///< those of `own_parameters` in which they differ

  [[nodiscard]] bool same_cycle_time() const { return before.cycle_time == after.cycle_time; }
  /// Both sides mean the same.
  [[nodiscard]] bool empty() const;
  /// Parameters that the control reads at start-up only have another meaning now.
  [[nodiscard]] bool needs_restart() const;
};

using AxisPair = std::pair<ComparedAxis const*, ComparedAxis const*>;

/// Each axis with that of its number (kopf.achs_nr, where lists set it, and no other axis of the machine has
/// it); the others by name. Two machines of one axis each: these. A stripped image and a machine of as many
/// axes: by their order.
[[nodiscard]] std::vector<AxisPair> pair_axes(ComparedMachine const& before, ComparedMachine const& after);

/// `all`: parameters that one side sets to what is its default, too.
[[nodiscard]] MachineDifference compare_machines(ComparedMachine const& before, ComparedMachine const& after,
                                                 bool all);

/// Two axes; of one machine, `before` and `after` are the same.
[[nodiscard]] MachineDifference compare_axes(ComparedMachine const& before, ComparedAxis const& old_axis,
                                             ComparedMachine const& after, ComparedAxis const& new_axis,
                                             bool all);

/// The axis with this name (as programs or lists call it), number, or list. Failure for an unknown or
/// ambiguous name, which names the axes there are.
[[nodiscard]] ComparedAxis const& axis_called(ComparedMachine const& machine, std::string const& name);

}  // namespace axisc
