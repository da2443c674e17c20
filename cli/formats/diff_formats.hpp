// Output formats of `axisc diff`.
#pragma once

#include "diagnostics/message.hpp"
#include "image/image_difference.hpp"

#include <string>

namespace axisc::cli {

struct ShownDifference {
  std::string before, after;  ///< the inputs' names
  image::ImageDifference const& difference;
  double feed_mm_per_min = 1000;  ///< of the corner
};

[[nodiscard]] std::string diff_text(ShownDifference const& shown, Language language);
/// For the description of a review.
[[nodiscard]] std::string diff_markdown(ShownDifference const& shown, Language language);
[[nodiscard]] std::string diff_json(ShownDifference const& shown);

/// The default in plain numbers.
[[nodiscard]] std::optional<std::string> default_of(image::ParameterChange const& change);

/// Corner deviation in µm for a path of `feed` mm/min.
[[nodiscard]] std::optional<double> corner_deviation_um(image::ChainFigures const& figures, double feed,
                                                        design::CycleTime cycle_time);

}  // namespace axisc::cli
