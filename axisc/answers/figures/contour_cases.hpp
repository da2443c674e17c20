// The feeds and orders that a picture of a contour shows, for one state or two.
#pragma once

#include "axisc/answers/figures/plots.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

/// One drawn contour.
struct ContourCurve {
  std::string name;
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  double velocity = 0;                        ///< position units per NC cycle
  std::vector<motion::ChainAnswer> answers;   ///< of the drawn plane: two
  std::pair<std::size_t, std::size_t> plane;  ///< axes of the group
};

/// By feed, then by order; of an earlier state first. `deviation` decides which plane is drawn.
[[nodiscard]] std::vector<ContourCurve> contour_curves(
    ContourSubject const& subject, ContourRequest const& wanted,
    std::function<double(std::vector<motion::ChainAnswer> const& plane, double velocity)> const& deviation);

/// "X/Y".
[[nodiscard]] std::string plane_name(ContourSubject const& subject, ContourCurve const& curve);

/// A length of the path in µm, four digits.
[[nodiscard]] Wording micrometres(double units);

/// Deviations by case: before, now and the difference where there are two states.
[[nodiscard]] pictures::Table deviation_table(ContourSubject const& subject,
                                              std::vector<ContourCurve> const& curves,
                                              std::vector<double> const& deviations);

}  // namespace axisc
