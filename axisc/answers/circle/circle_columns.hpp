// Which columns of a recording are the positions of a circle's axes.
#pragma once

#include "axisc/files/recorded_positions.hpp"
#include "axisc/files/recording_file.hpp"
#include "configuration/machine/machine.hpp"
#include "image/image_contents.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

/// The axes of a plane, as indices into the machine's.
using Plane = std::array<std::size_t, 2>;

struct CircleMachine {
  std::string path;  ///< as the user names it
  machine::Machine const& machine;
  image::ImageContents const& image;
};

struct CircleColumns {
  std::vector<ChosenColumn> actuals, setpoints;  ///< two, and two or none
  bool is_filtered = false;                      ///< the setpoints are those after the filters
};

/// A column is the one that an option names, the axis' object or its name in a template ("X actual"), or, of
/// a setpoint, "X setpoint". Setpoints before the filters come first, then those after them. Failure (AX9005)
/// that lists what there is where an actual position is missing, or the setpoint of one axis alone.
[[nodiscard]] CircleColumns circle_columns(CircleMachine const& machine, Plane const& plane,
                                           RecordingFile const& file,
                                           std::vector<AxisColumn> const& setpoints,
                                           std::vector<AxisColumn> const& actuals);

/// The only one of the planes of which the first file has actual positions. Failure otherwise.
[[nodiscard]] Plane recorded_plane(CircleMachine const& machine, RecordingFile const& file,
                                   std::vector<AxisColumn> const& actuals, std::vector<Plane> planes);

}  // namespace axisc
