// Filters against the vibration of an axis, and Improved Position Control.
#pragma once

#include "axisc/answers/suggestion/damping.hpp"
#include "axisc/answers/suggestion/ramp_times.hpp"
#include "axisc/answers/suggestion/suggestion.hpp"
#include "axisc/checking/path_machine.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc {

struct SuggestQuestion {
  MachineRequest machine;
  std::optional<std::string> axis;        ///< that vibrates; none: that of the list
  std::optional<std::string> resonances;  ///< see read_resonances(); none: those of the measurement
  std::vector<std::string> measured;      ///< files: recordings of the axis
  SignalColumns columns;                  ///< of each of them
  std::optional<std::string> plant;       ///< a file: compare Improved Position Control too
  double tolerance_mm = 0.01, feed_mm_per_min = 4000, radius_mm = 10;
  std::optional<tuning::Goal> goal;
  std::optional<machine::Slope> slope;  ///< with which the axis moves; none: that of its channel
};

/// Who says with which slope the axis moves.
enum class SlopeSource : std::uint8_t { option, channel_list, control_default };

struct Suggested {
  std::string axis, group;
  tuning::Task task = {};
  std::variant<NoSuggestion, Suggestion> filters = {};
  SlopeSource slope_source = SlopeSource::control_default;
  std::optional<RampAnswer> ramps = {};       ///< unless the slope is STEP
  std::optional<DampingAnswer> damping = {};  ///< with a plant
  std::optional<Message> remark = {};         ///< the feed that counts is another one
  std::optional<Message> refusal = {};        ///< why no filters are suggested
  std::vector<std::string> files = {};        ///< that were read

  /// Null where none are suggested.
  [[nodiscard]] Suggestion const* suggestion() const { return std::get_if<Suggestion>(&filters); }
  /// Anything is suggested.
  [[nodiscard]] bool helps() const {
    return suggestion() != nullptr || (damping && damping->damping() != nullptr) ||
           (ramps && ramps->quickest() != nullptr);
  }
};

/// None where `errors` of the machine prevent it. Failure for what cannot be read, and for an axis that is
/// not there or moves on no path.
[[nodiscard]] std::optional<Suggested> suggest(Workspace& workspace, SuggestQuestion const& question,
                                               ErrorSink const& errors);

}  // namespace axisc
