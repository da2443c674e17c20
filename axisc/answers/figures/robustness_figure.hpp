// What Vibration Guard leaves of an oscillation, over the frequency that it really has.
#pragma once

#include "axisc/answers/figures/plots.hpp"

namespace axisc {

/// The axis has a guard: from its lists, or from a command of its channel.
[[nodiscard]] bool has_guard(image::ImageContents const& contents, std::size_t axis);

/// Residual vibration (design::residual_vibration) of every guard that the lists and the commands of the
/// channels give the axes, from half to one and a half times its frequency, at its own damping, with a line
/// at 5 %; below, the intervals in which at most 5 % are left, as shares of the configured frequency, beside
/// the vendor's guide values. Axes with the same guard are drawn once.
[[nodiscard]] pictures::Figure robustness_figure(PlotSubject const& subject);

}  // namespace axisc
