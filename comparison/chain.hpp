// A chain of filters as plain numbers, run over a whole recording.
#pragma once

#include "design/filter_design.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::comparison {

/// Either second-order sections with a share, or the taps of a kernel: those, where there are any.
struct Link {
  std::vector<design::IncrementSection> sections{};
  bool blocks_constant = false;
  double share = 1;  ///< of the sections; taps have theirs in them
  std::vector<double> taps{};
};

using Chain = std::vector<Link>;

[[nodiscard]] Link link_of(design::FilterDesign const& filter);

/// The answer to `input`, from rest at its first value.
[[nodiscard]] std::vector<double> respond(Chain const& chain, std::span<double const> input);

/// Cycles after which a state that is not known has less than a millionth of its effect; at most 20000.
[[nodiscard]] std::size_t settling_cycles(Chain const& chain);

}  // namespace axisc::comparison
