// What #FILTER commands made of an axis' linear-phase filter while a scope recorded it.
#pragma once

#include "analysis/comparison/readings.hpp"
#include "axisc/answers/execution/timed_commands.hpp"
#include "image/image_contents.hpp"

#include <string>
#include <vector>

namespace axisc {

/// `commands` by rising cycle. Failure if the axis has no filter that they could switch, if the image lacks a
/// kernel for one of them, or if one comes while the filter still changes over.
[[nodiscard]] std::vector<comparison::KernelSwitch> kernel_switches(std::vector<TimedCommand> const& commands,
                                                                    image::ImageContents const& image,
                                                                    std::size_t axis,
                                                                    std::string const& path);

}  // namespace axisc
