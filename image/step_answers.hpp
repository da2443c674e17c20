// The step responses of an image's axes for several users: the image is executed once for all of them.
#pragma once

#include "image/chain_figures.hpp"
#include "image/runtime_host.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::image {

class StepAnswers {
 public:
  /// For an image that read_image() accepted; both must outlive this. Nothing is executed yet.
  StepAnswers(std::span<std::byte const> image, ImageContents const& contents)
      : image_(image), contents_(&contents) {}

  /// The figures of chain_figures().
  [[nodiscard]] ChainFigures const& figures(std::size_t axis);
  /// The answer to a step of 1 from rest, one number per cycle; invalid after the next call. Empty where the
  /// runtime refuses the image. Cost: the cycles that were not executed yet, of all axes; they are kept.
  [[nodiscard]] std::span<double const> answer(std::size_t axis, std::uint64_t cycles);
  /// The cycles executed so far.
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }

 private:
  [[nodiscard]] bool starts();

  std::span<std::byte const> image_;
  ImageContents const* contents_;
  std::vector<ChainFigures> figures_;  ///< of all axes; empty until the first is asked for
  std::optional<RuntimeHost> host_;
  std::vector<std::vector<double>> answers_;  ///< of each axis
  std::uint64_t cycles_ = 0;
};

}  // namespace axisc::image
