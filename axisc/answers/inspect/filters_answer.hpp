// The filters of each axis in words, and what they cost, in one table.
#pragma once

#include "axisc/files/image_file.hpp"
#include "presentation/document.hpp"

#include <string>

namespace axisc {

/// Filters of the setpoint in the order in which they act; delay, -3 dB frequency, overshoot and settling
/// time of the chain as it starts, in the terms of chain_figures(). `name` is the machine's, for readers.
/// Cost: that of chain_figures().
[[nodiscard]] presentation::Document filters_answer(std::string const& name, ImageFile const& image);

}  // namespace axisc
