// An image read back into plain values, for `inspect`, `response` and comparisons. The runtime does not use
// this.
#pragma once

#include "axisrt.h"
#include "design/filter_design.hpp"
#include "design/filter_specification.hpp"
#include "design/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace axisc::codegen {

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
  double position_window = 0, velocity_limit = 0, acceleration_limit = 0;
  double delay_cycles = 0;  ///< setpoint chain at 0 Hz
  double peak_gain = 1;     ///< setpoint chain
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
  std::vector<ImageList> lists;
};

/// Runs axisrt_verify first; a status other than AXISRT_OK is returned instead of contents.
[[nodiscard]] std::variant<ImageContents, axisrt_status> read_image(std::span<std::byte const> bytes);

}  // namespace axisc::codegen
