// What differs between two machines or axes, as an answer.
#pragma once

#include "axisc/answers/difference/machine_difference.hpp"
#include "presentation/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ShownDifference {
  std::string before, after;  ///< the inputs' names, or those of two axes of one machine
  MachineDifference const& difference;
  double feed_mm_per_min = 1000;                 ///< of the corner
  std::optional<std::string> read_by_both = {};  ///< see ComparedSides
};

[[nodiscard]] presentation::Document difference_answer(ShownDifference const& shown);

/// For a cover: what differs, each change of a parameter once with the axes that have it, and what needs a
/// restart.
[[nodiscard]] std::vector<presentation::Block> change_summary(ShownDifference const& shown);

/// Corner deviation in µm for a path of `feed` mm/min.
[[nodiscard]] std::optional<double> corner_deviation_um(image::ChainFigures const& chain, double feed,
                                                        design::CycleTime cycle_time);

}  // namespace axisc
