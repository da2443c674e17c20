// An image read back into plain values, for `inspect`, `response` and comparisons. The runtime does not use
// this.
#pragma once

#include "axisrt.h"
#include "configuration/machine/machine.hpp"
#include "design/filter_design.hpp"
#include "design/filter_specification.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace axisc::image {

struct ImageFilter {
  std::uint32_t index = 0;
  design::FilterSpecification specification;
  design::FilterDesign design;
  double peak_gain = 0;
  double overshoot = 0;
  double kernel_sum = 1;
  std::vector<double> self_test_input;
  std::vector<double> self_test_output;
};

struct ImageKernel {
  design::KernelSpecification specification;
  design::KernelDesign design;  ///< taps as differences of the tail sums
  double peak_gain = 1;
  double overshoot = 0;
  double tail_gain = 0;
  std::vector<double> self_test_input;
  std::vector<double> self_test_output;
};

/// The kernel of an axis.
struct ImageSlot {
  machine::KernelFamily family = machine::KernelFamily::fir;
  std::uint32_t index = 0;
  std::optional<std::size_t> kernel;  ///< of the lists' values; none: the setpoint passes unchanged
  bool on_at_start = false;
  std::optional<std::size_t> group;
};

struct ImageBank {
  machine::FilterParameters parameters;
  bool hsc = false;
  std::vector<std::optional<std::size_t>> kernels;  ///< of each member
  std::uint32_t fade_cycles = 0;                    ///< 0: at standstill only

  [[nodiscard]] machine::KernelFamily family() const { return machine::family_of(parameters, hsc); }
};

struct ImageGroup {
  std::string name;  ///< empty in a stripped image
  std::vector<std::size_t> members;
  std::vector<ImageBank> banks;
  std::uint32_t off_fade_cycles = 0;
};

/// A stage of Improved Position Control. Its oscillator, if any, is the first filter: type 0, the damping as
/// quality.
struct ImageStage {
  std::uint32_t index = 0;
  machine::StageMode mode = machine::StageMode::direct;
  bool has_oscillator = false;
  double weight = 0, weight_numerator = 0, weight_denominator = 0;
  std::vector<ImageFilter> filters;
};

struct ImageControl {
  std::size_t source = 0;  ///< axis whose stages give the additive velocity
  std::vector<ImageStage> stages;
  machine::DriveScaling scaling;
  double limit = 0, limit_factor = 0;
  double increments_per_velocity = 0;
};

struct ImageValue {
  std::string name, value, list;
  std::uint32_t line = 0;
};

struct ImageAxis {
  std::string name;  ///< empty in a stripped image
  std::uint32_t number = 0;
  std::uint32_t type = 1;
  std::vector<ImageFilter> filters;
  std::vector<ImageFilter> interface_filters;
  std::optional<ImageSlot> slot;
  std::optional<ImageControl> control;
  double position_window = 0, velocity_limit = 0, acceleration_limit = 0;
  double delay_cycles = 0;  ///< setpoint chain at 0 Hz, as it starts
  double peak_gain = 1;     ///< setpoint chain, as it starts
  std::vector<ImageValue> values;
};

struct ImageList {
  std::string name;
  std::array<std::uint8_t, 32> sha256{};
};

struct ImageContents {
  std::uint16_t format_major = 0, format_minor = 0;
  std::uint64_t size = 0;
  design::CycleTime cycle_time;
  std::uint32_t image_version = 0;
  std::string compiler_version;
  std::array<std::uint8_t, 32> source_digest{};
  std::vector<ImageAxis> axes;
  std::vector<ImageKernel> kernels;
  std::vector<ImageGroup> groups;
  std::vector<ImageList> lists;
};

/// Runs axisrt_verify first; a status other than AXISRT_OK is returned instead of contents.
[[nodiscard]] std::variant<ImageContents, axisrt_status> read_image(std::span<std::byte const> bytes);

}  // namespace axisc::image
