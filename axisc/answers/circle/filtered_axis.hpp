// What the setpoint chain of an axis does to a sine, filter by filter.
#pragma once

#include "configuration/machine/drive_path.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

/// At one frequency.
struct FilterShare {
  std::string filter;  ///< "filter[0] PT2", "filter_fir 2" with its type, "filter[0] HSC", "vib_guard"
  double gain = 1;     ///< |H|
  double delay_s = 0;  ///< phase delay
};

struct FilteredAxis {
  std::vector<FilterShare> shares;  ///< in the order of the chain

  /// Of all in series.
  [[nodiscard]] double gain() const;
  [[nodiscard]] double delay_s() const;
};

/// With the linear-phase kernel of the lists switched on, as after #FILTER ON or #VIB GUARD ON. `later` is
/// what delays the position after the filters; the last share where it is not 0.
[[nodiscard]] FilteredAxis filtered_axis(image::ImageContents const& image, std::size_t axis,
                                         machine::PositionDelay const& later, double radians_per_second);

/// A filter of the chain blocks the constant part: the axis does not get to the circle.
[[nodiscard]] bool blocks_constant(image::ImageAxis const& axis);

}  // namespace axisc
