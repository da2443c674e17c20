// Output formats of `axisc diff`.
#pragma once

#include "axisc/answers/difference/machine_difference.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>

namespace axisc {

struct ShownDifference {
  std::string before, after;  ///< the inputs' names, or those of two axes of one machine
  MachineDifference const& difference;
  double feed_mm_per_min = 1000;  ///< of the corner

  [[nodiscard]] std::string heading() const {
    return difference.of_one_machine ? difference.before.input : before + " → " + after;
  }
};

[[nodiscard]] std::string diff_text(ShownDifference const& shown, Language language);
/// For the description of a review.
[[nodiscard]] std::string diff_markdown(ShownDifference const& shown, Language language);
[[nodiscard]] std::string diff_json(ShownDifference const& shown, Language language);

/// Corner deviation in µm for a path of `feed` mm/min.
[[nodiscard]] std::optional<double> corner_deviation_um(image::ChainFigures const& chain, double feed,
                                                        design::CycleTime cycle_time);

}  // namespace axisc
