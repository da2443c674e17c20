// The kernel types, a row each: which values of a specification a type uses, and how long it may be.
#pragma once

#include "design/kernels/kernel_design.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace axisc::design {

struct KernelKind {
  KernelType type;
  std::uint32_t longest_order;
  bool uses_frequency = false;
  bool uses_quality = false;
  bool computes_order = false;  ///< from the frequency; the order of a specification is ignored
};

/// In the order of KernelType.
inline constexpr std::array kernel_kinds{
    KernelKind{.type = KernelType::moving_average, .longest_order = longest_kernel_order},
    KernelKind{.type = KernelType::gaussian, .longest_order = longest_kernel_order, .uses_quality = true},
    KernelKind{
        .type = KernelType::windowed_sinc, .longest_order = longest_kernel_order, .uses_frequency = true},
    KernelKind{.type = KernelType::time_delay, .longest_order = longest_kernel_delay},
    KernelKind{.type = KernelType::novib,
               .longest_order = longest_kernel_order,
               .uses_frequency = true,
               .computes_order = true},
    KernelKind{.type = KernelType::vibration_guard,
               .longest_order = 4,  // its modes
               .uses_frequency = true,
               .uses_quality = true},
};

static_assert([] {
  for (std::size_t i = 0; i < kernel_kinds.size(); ++i) {
    if (static_cast<std::size_t>(kernel_kinds[i].type) != i) return false;
  }
  return true;
}());

[[nodiscard]] constexpr KernelKind const& kind_of(KernelType type) {
  return kernel_kinds[static_cast<std::size_t>(type)];
}

}  // namespace axisc::design
