// The parts of a runtime as create builds them, each from its sections of a verified image.
#pragma once

#include "runtime/image_view.hpp"
#include "runtime/layout.hpp"
#include "runtime/runtime_object.hpp"

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

/// Kernels and their tails; one kernel without tails behind them.
void build_kernels(ImageView const& view, Layout const& layout, Memory memory);
/// Slots in the steady state, switched as at start-up, put into the setpoint chains. Expects kernels and chains.
void build_slots(ImageView const& view, Layout const& layout, Memory memory);
/// Groups with their banks. Expects kernels and slots.
void build_groups(ImageView const& view, Layout const& layout, Memory memory);
/// Improved Position Control. Expects filters.
void build_controls(ImageView const& view, Layout const& layout, Memory memory);

}  // namespace axisc::runtime
