// Checked machines without lists, for the tests of this folder.
#pragma once

#include "configuration/machine/machine.hpp"
#include "image/image_contents.hpp"
#include "image/runtime_host.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace axisc::test {

/// Three axes and a spindle: shared and own sections, shares, a pure delay, the additional interface, a
/// source map with repeated texts, an axis without filters.
[[nodiscard]] machine::Machine sample_machine();

/// One translatory axis X with these filters as filter[0], filter[1], ...
[[nodiscard]] machine::Machine machine_with(std::vector<design::FilterSpecification> const& filters,
                                            design::CycleTime cycle_time);

/// Two channels with FIR and HSC kernels, their banks and fades, position control with a gantry slave: X
/// Gaussian, PT1 and the manual's two stages; Y a time delay; Z NoVib in front of a band-pass; W slave of X;
/// C a filter of order 0.
[[nodiscard]] machine::Machine kernel_machine();
/// The example of the manual: 53 Hz DIRECT, 11 Hz INDIRECT.
[[nodiscard]] machine::PositionControl manual_position_control();
/// A set of #FILTER parameters.
[[nodiscard]] inline machine::FilterParameters filter_set(std::optional<std::uint32_t> order,
                                                          std::optional<double> share_percent = {},
                                                          std::optional<design::Hertz> frequency = {},
                                                          std::optional<double> quality = {}) {
  return {.order = order, .share_percent = share_percent, .frequency = frequency, .quality = quality};
}
/// filter_fir.
[[nodiscard]] machine::ConfiguredKernel fir(design::KernelSpecification const& specification,
                                            bool on_at_start);

/// Uniform numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// 0 <= x < 1.
  [[nodiscard]] double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
  [[nodiscard]] std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(unit() * count);
  }

 private:
  std::mt19937_64 engine_;
};

/// Any standard filter within its documented ranges, frequencies down to `lowest`.
[[nodiscard]] design::FilterSpecification random_filter(Random& random, design::CycleTime cycle_time,
                                                        design::Hertz lowest);
/// A cycle time from 125 µs to 4 ms, one to four axes with up to three filters and an interface filter each.
[[nodiscard]] machine::Machine random_machine(Random& random, double lowest_frequency_times_cycle);

/// The same with any FIR or HSC filters, a channel with parameter sets, position control and gantry slaves.
[[nodiscard]] machine::Machine random_kernel_machine(Random& random, double lowest_frequency_times_cycle);

/// Fails the test when there is none.
[[nodiscard]] image::RuntimeHost runtime_for(std::span<std::byte const> image);
[[nodiscard]] image::ImageContents contents_of(std::span<std::byte const> image);

}  // namespace axisc::test
