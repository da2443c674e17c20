// Other ways from the analogue filter to the digital one than the bilinear transform.
#pragma once

#include "comparison/chain.hpp"

#include <cstdint>
#include <optional>

namespace axisc::comparison {

enum class Discretisation : std::uint8_t { backward_euler, forward_euler, matched, matched_poles };

/// `bilinear` has no pre-warping, so that its inverse is the analogue filter. None for an unstable result, and for
/// matched poles where the filter blocks the constant part, whose gain could not be normalised.
[[nodiscard]] std::optional<Link> rediscretised(Link const& bilinear, Discretisation discretisation);

}  // namespace axisc::comparison
