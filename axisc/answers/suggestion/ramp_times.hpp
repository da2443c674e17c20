// `axisc suggest`: ramp times (P-AXIS-00195 to 00198) in the place of filters.
//
// They shape the motion of the vibrating axis alone, before any filter: lists of other axes stay as they are.
#pragma once

#include "analysis/tuning/suggestion/ramp_candidates.hpp"
#include "axisc/answers/suggestion/suggestion.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct RampAnswer {
  tuning::RampCandidates found;
  // Of the quickest that does enough, where there is one:
  std::vector<AxisLines> axes = {};  ///< the axis, or the master of its gantry
  ListEdits edits = {};
  std::vector<std::string> findings = {};  ///< as those of an Alternative

  /// Null where none does enough.
  [[nodiscard]] tuning::RampCandidate const* quickest() const {
    return found.quickest ? &found.candidates[*found.quickest] : nullptr;
  }
};

/// None with the slope STEP.
[[nodiscard]] std::optional<RampAnswer> ramp_times_for(SuggestionSubject const& subject,
                                                       tuning::Task const& task);

/// Number of the suggestion, behind that of Improved Position Control.
inline constexpr std::size_t ramps_number = tuning::senses + 2;

}  // namespace axisc
