// The bounds of an image, computed again from its coefficients and compared with what it claims.
#pragma once

#include "runtime/bounds/bound_record.hpp"
#include "runtime/bounds/change_bound.hpp"
#include "runtime/bounds/claims.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::image {

using runtime::bounds::BoundRecord;
using runtime::bounds::ChangeBound;
using runtime::bounds::Claim;

struct CheckedBound {
  BoundRecord computed;
  std::optional<BoundRecord> claimed;  ///< none where the image has no section `bounds`
  Claim failing = Claim::none;         ///< the first field that is not true
};

/// What changes of kernels in motion add to the motion of an axis.
struct CheckedChange {
  ChangeBound bound;
  bool holds = true;  ///< it is within a quarter of the axis' limits
};

struct CheckedBounds {
  bool is_in_image = false;
  std::vector<CheckedBound> records;   ///< in the order of the image
  std::vector<CheckedChange> changes;  ///< of each axis

  /// Claims that are not true.
  [[nodiscard]] std::size_t failures() const;
};

/// Records of the section `bounds`; none where the image has no such section. Expects an image that was
/// accepted, aligned to 64 bytes.
[[nodiscard]] std::optional<std::uint32_t> bound_record_count(std::span<std::byte const> image);

/// Expects an image that was accepted, aligned to 64 bytes. Cost: that of the responses of all chains with
/// all kernels.
[[nodiscard]] CheckedBounds check_bounds(std::span<std::byte const> image);

}  // namespace axisc::image
