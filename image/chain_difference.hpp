// What another filter configuration does to an axis: figures of both chains, side by side.
#pragma once

#include "image/chain_figures.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axisc::image {

/// Magnitude at a characteristic frequency of either side.
struct GainChange {
  design::Hertz frequency;
  double before = 1, after = 1;
};

struct ChainDifference {
  ChainFigures before, after;
  std::vector<GainChange> gains;
  design::Readings reading_before, reading_after;
};

struct ImageAxisSide {
  std::span<std::byte const> image;
  ImageContents const& contents;
  std::size_t axis = 0;
};

/// None where both axes filter their setpoints alike: the same filters and taps at the same NC cycle time.
[[nodiscard]] std::optional<ChainDifference> compare_chains(ImageAxisSide const& before,
                                                            ImageAxisSide const& after);

}  // namespace axisc::image
