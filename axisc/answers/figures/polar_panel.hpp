// A circle with its deviations magnified.
#pragma once

#include "presentation/pictures/figure.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace axisc {

/// Directions in which curves are drawn.
inline constexpr std::size_t polar_directions = 720;

/// Radius 1 of the picture is the programmed one.
class PolarPanel {
 public:
  /// The largest deviation is drawn up to 0.3 radii from the circle; `radius` in the same unit.
  PolarPanel(double radius, double largest);

  /// By how much deviations are magnified: a round number.
  [[nodiscard]] double factor() const { return factor_; }
  /// At this deviation, with words beside it.
  enum class Words : std::uint8_t { above, below };
  void add_ring(double deviation, std::string name, std::string words = {}, Words place = Words::above);
  /// `points` in the unit of the radius, about the centre of the circle.
  void add(pictures::Curve style, std::vector<pictures::Point> const& points);

  /// With its own horizontal axis.
  [[nodiscard]] pictures::Panel take() &&;

 private:
  [[nodiscard]] double shown(double deviation) const { return 1 + deviation / radius_ * factor_; }

  double radius_, factor_;
  pictures::Panel panel_;
};

}  // namespace axisc
