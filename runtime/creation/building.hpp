// The parts of a runtime as create builds them, each from its sections of a verified image.
#pragma once

#include "runtime/creation/layout.hpp"
#include "runtime/creation/shape.hpp"
#include "runtime/runtime_object.hpp"
#include "runtime/verification/image_view.hpp"

#include <stddef.h>
#include <stdint.h>

namespace axisc::runtime {

/// The caller's memory, cut into the parts of a layout.
struct Memory {
  uint8_t* bytes;
  template <class T>
  [[nodiscard]] T* part(uint64_t offset) const {
    return reinterpret_cast<T*>(bytes + static_cast<size_t>(offset));
  }
};

/// The next multiple of a vector of the widest group, so that none is cut by a cache line.
[[nodiscard]] constexpr uint64_t whole_lines(uint64_t doubles) {
  return (doubles + most_lanes - 1) / most_lanes * most_lanes;
}

/// Doubles of a group's state.
[[nodiscard]] uint32_t state_stride(Group const& group);

/// True if two groups of one batch have the same coefficients in every lane.
[[nodiscard]] bool same_constants(ImageView const& view, PortKind port, Group const& a, Group const& b,
                                  uint32_t step);

/// The largest `of` among the bounds that the image states for the setpoint chain of an axis, with whichever
/// kernel its slot can execute; 0 where there are none. They begin at `next`, which moves to the next axis.
template <size_t Offset>
[[nodiscard]] double largest_bound(ImageView const& view, uint32_t axis,
                                   Field<record::bound, double, Offset> of, uint32_t& next) {
  double largest = 0;
  for (; next < view.bounds.count && view.bounds[next][field::bound::axis] == axis; ++next) {
    Record<record::bound> const record = view.bounds[next];
    if (record[field::bound::port] == axim_port_velocity) break;
    if (record[field::bound::port] == axim_port_setpoint && record[of] > largest) largest = record[of];
  }
  return largest;
}

/// Kernels and their tails; one kernel without tails after them.
void build_kernels(ImageView const& view, Layout const& layout, Memory memory);
/// Lines in their lanes, in the steady state for 0 and never reset. Expects kernels.
LinePort build_port(ImageView const& view, PortKind port, uint32_t lanes, Layout const& layout,
                    Memory memory);
/// Channels with their banks. Expects kernels and ports.
void build_channels(ImageView const& view, Layout const& layout, Memory memory);
/// The largest plausible move of an output in a cycle, where the image knows the axis' limits. Expects ports.
void limit_increments(ImageView const& view, axisrt const& runtime);
/// Improved Position Control.
void build_controls(ImageView const& view, Layout const& layout, Memory memory);

}  // namespace axisc::runtime
