// Figures of an image: each shows what another command computes.
#pragma once

#include "cli/files/image_file.hpp"
#include "diagnostics/message.hpp"
#include "pictures/figure.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc::cli {

/// What the figures of one run of `axisc plot` have in common.
struct PlotSubject {
  ImageFile const& file;
  image::RuntimeHost& host;  ///< after the commands of --at
  std::vector<std::size_t> axes;
  Language language = Language::english;
};

struct ResponsePlot {
  bool linear_frequency = false;
  bool linear_magnitude = false;
  bool wraps_phase = false;
  std::vector<double> marks = {};  ///< in Hz
};

/// Magnitude, phase and group delay over frequency, as `response` computes them; of a single axis with each of its
/// filters.
[[nodiscard]] pictures::Figure response_figure(PlotSubject const& subject, ResponsePlot const& wanted);

/// The answer to a step of 1 in position, from standstill, and its velocity and acceleration, as `run` computes them.
[[nodiscard]] pictures::Figure step_figure(PlotSubject const& subject);

/// "filter[0] BANDSTOP 42 Hz".
[[nodiscard]] std::string filter_label(image::ImageFilter const& filter);

}  // namespace axisc::cli
