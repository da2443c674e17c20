// `axisc suggest --plant`: what Improved Position Control can do for the vibrating axis.
//
// It acts within the position loop of that axis alone: the setpoints of the others stay as they are, and so
// do their lists.
#pragma once

#include "analysis/tuning/position_control/damping_search.hpp"
#include "axisc/answers/suggestion/suggestion.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc {

/// A gantry's axes are coupled by mechanics that no plant file holds.
struct InGantry {};

struct DampingAnswer {
  std::string plant_path;
  double kv = 0;  ///< 1/s
  std::variant<tuning::Damping, tuning::NoDampingFound, InGantry> found;
  std::vector<AxisLines> axes = {};  ///< of the group; with lines for the vibrating axis alone
  ListEdits edits = {};
  std::vector<std::string> findings = {};  ///< as those of an Alternative

  [[nodiscard]] tuning::Damping const* damping() const { return std::get_if<tuning::Damping>(&found); }
};

/// Failure for a plant file that cannot be used, or has no plant of the axis.
[[nodiscard]] DampingAnswer damping_for(SuggestionSubject const& subject, tuning::Task const& task,
                                        std::string const& plant_path);

/// Number of the suggestion, behind those of filters.
inline constexpr std::size_t damping_number = tuning::senses + 1;

}  // namespace axisc
