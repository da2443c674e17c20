// Figures of an axis' setpoint chain as it starts, in the terms of an engineer. Everything in the time domain
// is computed by the runtime executing the image.
#pragma once

#include "design/units.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::image {

struct ChainFigures {
  double delay_cycles = 0;  ///< group delay at 0 Hz
  std::optional<std::uint64_t>
      settling_cycles;   ///< until a step stays within 0.01 %; none beyond longest_settling
  double overshoot = 0;  ///< of a step, as a share of its height
  /// How far the contour passes from a sharp corner of 90° between two axes with this chain, for a path of
  /// one unit per cycle: times feed and cycle time it is the contour deviation. None where the chain blocks
  /// the constant part.
  std::optional<double> corner_deviation;
};

/// A step that has not settled then is not followed further.
inline constexpr std::uint64_t longest_settling = std::uint64_t{1} << 18U;

/// Figures of axes of an image that read_image() accepted, each named once. The runtime executes all of them
/// at once. Cost: that of creating it, and of as many cycles of all axes of the image as the slowest needs.
[[nodiscard]] std::vector<ChainFigures> chain_figures(std::span<std::byte const> image,
                                                      ImageContents const& contents,
                                                      std::span<std::size_t const> axes);

/// The figures of one axis. For several, one call is cheaper: the runtime always executes the whole image.
[[nodiscard]] ChainFigures chain_figures(std::span<std::byte const> image, ImageContents const& contents,
                                         std::size_t axis);

/// Whether a setpoint is amplified by `peak_gain`, but for a millionth. If not, that is an upper bound: of a
/// response too long to be summed up, or of filters combined with a kernel, whose gains are multiplied. Cost:
/// until the response has settled, at most some ten milliseconds.
[[nodiscard]] bool reaches_peak_gain(ImageContents const& contents, std::size_t axis);
[[nodiscard]] bool reaches_peak_gain(ImageFilter const& filter);

/// Magnitude of the chain, with the kernel that works from start-up, at one frequency.
[[nodiscard]] double chain_magnitude(ImageContents const& contents, std::size_t axis,
                                     design::Hertz frequency);

/// 20·log10; none below -300 dB, where only rounding is left.
[[nodiscard]] std::optional<double> decibels(double magnitude);

/// The frequencies that the chain's filters are made for, rising, each once: fg_f0, the cut-off 1/(2π
/// time_constant), fcut.
[[nodiscard]] std::vector<design::Hertz> characteristic_frequencies(ImageContents const& contents,
                                                                    std::size_t axis);

/// The lowest frequency at which the magnitude of the chain falls to 1/√2 (-3.01 dB); none where it stays
/// above up to 0.5/T, or is below from the start. Cost: a thousand evaluations of the response.
[[nodiscard]] std::optional<design::Hertz> corner_frequency(ImageContents const& contents, std::size_t axis);

/// Rising, each once.
void sort_frequencies(std::vector<design::Hertz>& frequencies);

}  // namespace axisc::image
