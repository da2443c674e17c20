#include "image/fmu/runtime_size.hpp"

#include <algorithm>

namespace axisc::image {

namespace {

// Sizes of axisrt_c's structures where pointers have eight bytes, and some more; a test compares the sum.
constexpr std::size_t object = 640, kernel = 48, slot = 192, ring_padding = 16, line = 400, section = 48,
                      signal = 24;
constexpr std::size_t axis = 24, group = 24, bank = 48, stage = 48, control = 64, number = 8, rounding = 16;

std::size_t of_filters(std::vector<ImageFilter> const& filters) {
  std::size_t bytes = 0;
  for (auto const& filter : filters) {
    bytes += filter.design.sections.size() * section + (filter.design.delay_cycles + 1) * signal;
  }
  return bytes;
}

}  // namespace

std::size_t runtime_size(ImageContents const& contents) {
  std::size_t bytes = object + rounding * 16, longest = 1;
  for (auto const& each : contents.kernels) {
    bytes += kernel + each.design.tail_sums.size() * number;
    longest = std::max(longest, each.design.tail_sums.size());
  }
  bytes += kernel;
  for (auto const& each : contents.axes) {
    bytes += 2 * line + axis + of_filters(each.filters) + of_filters(each.interface_filters);
    if (each.slot) bytes += slot + (longest + ring_padding) * number;
    if (!each.control) continue;
    bytes += control;
    for (auto const& part : each.control->stages) bytes += stage + line + of_filters(part.filters);
  }
  for (auto const& each : contents.groups) {
    bytes += group + each.members.size() * number + each.banks.size() * (bank + each.members.size() * number);
  }
  return bytes;
}

}  // namespace axisc::image
