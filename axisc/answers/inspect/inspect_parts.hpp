// Parts of the answer about an image.
#pragma once

#include "axisc/answers/labels.hpp"
#include "axisc/files/image_file.hpp"
#include "presentation/document.hpp"

#include <span>
#include <string>

namespace axisc {

namespace labels {

inline constexpr Sentence self_test{"self-test samples", "Werte des Selbsttests"};

}  // namespace labels

/// For people five digits.
[[nodiscard]] constexpr presentation::Quantity rounded(double value,
                                                       presentation::Unit unit = presentation::Unit::none) {
  return {.value = value, .unit = unit, .digits = presentation::Digits::significant(5)};
}

[[nodiscard]] inline presentation::Value value_if(bool is_there, presentation::Value value) {
  return is_there ? std::move(value) : presentation::Value();
}
/// Nothing for the documented reading.
template <typename Reading>
[[nodiscard]] presentation::Value reading_value(Reading reading) {
  return value_if(reading != Reading::documented, word_of(reading));
}
[[nodiscard]] inline presentation::Value index_value(std::optional<std::size_t> index) {
  return value_if(index.has_value(), index.value_or(0));
}
/// "1.02", or "at most 1.02".
[[nodiscard]] presentation::Value peak_gain_value(double peak_gain, bool is_reached);
/// "kernel 3", or "passes unchanged".
[[nodiscard]] presentation::Value kernel_name(std::optional<std::size_t> kernel);

/// Names and values of a list, and where it has them.
[[nodiscard]] presentation::Table values_table(std::string key, std::span<image::ImageValue const> values,
                                               presentation::Audience audience);
/// The filters of a chain with their sections, and with what the lists set for each.
[[nodiscard]] presentation::Table filters_table(image::ImageAxis const& axis, bool interface,
                                                design::CycleTime cycle_time);
/// Impulses and robustness of a Vibration Guard.
[[nodiscard]] presentation::Section guard_section(image::ImageKernel const& kernel,
                                                  design::CycleTime cycle_time);
/// Improved Position Control.
[[nodiscard]] presentation::Section control_section(image::ImageContents const& image, std::size_t axis);
[[nodiscard]] presentation::Table kernels_table(image::ImageContents const& image,
                                                std::span<std::size_t const> kernels,
                                                presentation::Audience audience);
/// Every channel with the effect of each command; people see those of the axes.
[[nodiscard]] presentation::Sections channel_sections(image::ImageContents const& image,
                                                      std::span<std::size_t const> axes);

}  // namespace axisc
