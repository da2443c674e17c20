// The effect of another filter configuration on an axis: figures of both chains, side by side.
#pragma once

#include "image/chain_figures.hpp"
#include "image/image_contents.hpp"
#include "image/proved_bounds.hpp"

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
  ProvedBounds bounds_before, bounds_after;
};

/// An image that read_image() accepted.
struct ImageSide {
  std::span<std::byte const> image;
  ImageContents const& contents;
};

/// An axis of each side.
struct AxesToCompare {
  std::size_t before = 0, after = 0;
};

/// Both axes filter their setpoints alike: the same filters and taps at the same NC cycle time.
[[nodiscard]] bool filter_alike(ImageContents const& before, std::size_t a, ImageContents const& after,
                                std::size_t b);

/// For each pair, of which no axis is in two; none where both axes filter their setpoints alike: the same
/// filters and taps at the same NC cycle time. Cost: that of chain_figures() for all axes that differ, at
/// once.
[[nodiscard]] std::vector<std::optional<ChainDifference>> compare_chains(
    ImageSide const& before, ImageSide const& after, std::span<AxesToCompare const> pairs);

}  // namespace axisc::image
