// Symbols of axis lists for the numbers stored in an image.
#pragma once

#include "design/filter_kinds.hpp"
#include "image/image_contents.hpp"
#include "presentation/value.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// "LOWPASS".
[[nodiscard]] std::string_view type_word(design::FilterType type);
/// "CRIT_DAMPING".
[[nodiscard]] std::string_view prototype_word(design::Prototype prototype);

/// The kernel's English words for programs, and those for people.
[[nodiscard]] presentation::Symbol kernel_symbol(design::KernelType type);

/// "DIRECT".
[[nodiscard]] std::string_view mode_word(machine::StageMode mode);

/// `filter[0]`, `lr_param.add_interface.filter[0]`, or `kenngr.in_add_interface_filter_time`.
[[nodiscard]] std::string filter_path(image::ImageFilter const& filter, bool interface);

/// The values that the lists set for one filter, in the order of the lines.
[[nodiscard]] std::vector<image::ImageValue> settings_of(image::ImageAxis const& axis,
                                                         image::ImageFilter const& filter, bool interface);

}  // namespace axisc
