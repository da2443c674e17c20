// What holds for every setpoint of an axis, with whatever kernel a program switches on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace axisc::image {

struct ProvedBounds {
  double gain_high = 1;       ///< no setpoint is amplified more
  double overshoot_high = 0;  ///< share of a step
  /// With a constant setpoint the output is exactly that after so many NC cycles; none: not proved.
  std::optional<std::uint64_t> rest_cycles = 0;
};

/// The worst of the bounds of an axis' setpoints, with each of its kernels: as the image stores them, or
/// computed where it has no section `bounds`. An axis without filters passes setpoints unchanged. Expects an
/// image that was accepted, aligned to 64 bytes. Cost: to compute them, that of the responses of its chain.
[[nodiscard]] ProvedBounds proved_bounds(std::span<std::byte const> image, std::uint32_t axis);

}  // namespace axisc::image
