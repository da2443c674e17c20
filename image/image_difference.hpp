// What changed between two machines, as their images remember them: parameters, and what the changes do to the axes.
#pragma once

#include "image/chain_figures.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axisc::image {

/// A parameter that means something else now. A list that does not set it leaves the documented default.
struct ParameterChange {
  std::string name;
  std::optional<std::string> before, after;  ///< as written; none: not set
  std::optional<std::string> default_text;   ///< what counts where it is not set
  std::string place_before, place_after;     ///< "x.lis:12"; empty where not set
};

/// Magnitude at a characteristic frequency of either side.
struct GainChange {
  design::Hertz frequency;
  double before = 1, after = 1;
};

struct AxisChange {
  std::string name;
  std::vector<ParameterChange> parameters;
  bool filtering_changed = false;  ///< figures and gains are there
  ChainFigures before, after;
  std::vector<GainChange> gains;
};

struct ImageDifference {
  design::CycleTime cycle_time_before, cycle_time_after;
  std::vector<std::string> axes_removed, axes_added;
  std::vector<AxisChange> axes;  ///< those with a change, in the order of the new machine

  [[nodiscard]] bool empty() const {
    return axes.empty() && axes_removed.empty() && axes_added.empty() &&
           cycle_time_before == cycle_time_after;
  }
};

struct ImageSide {
  std::span<std::byte const> image;
  ImageContents const& contents;
};

/// Axes are the same when their names are; in a stripped image, when they stand at the same place. Two spellings of one
/// value (0x14 and 20, LOWPASS and 1) are no change.
[[nodiscard]] ImageDifference compare_images(ImageSide const& before, ImageSide const& after);

}  // namespace axisc::image
