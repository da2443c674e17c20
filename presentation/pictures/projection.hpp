// From the quantities of a panel to places in the picture, in pixels of its viewBox.
#pragma once

#include "presentation/pictures/figure.hpp"

namespace axisc::pictures {

/// One axis of a panel: low at `begin`, high at `end`. Values outside are drawn at the edge.
class Projection {
 public:
  Projection(Axis const& axis, double begin, double end);
  [[nodiscard]] double operator()(double value) const;

 private:
  Scale scale_;
  double low_, high_, begin_, end_;
};

/// Size and edges of a panel: pictures are 800 wide.
inline constexpr double picture_width = 800;
inline constexpr double panel_left = 76;
inline constexpr double panel_right = picture_width - 20;

/// Ranges of both axes widened so that a length is drawn alike in either direction of a panel of this height.
void make_equal(Axis& x, Axis& y, double height);

}  // namespace axisc::pictures
