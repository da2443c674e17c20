// Two generations of filters at the additional interface.
#pragma once

#include <cstdint>

namespace axisc::machine {

/// ConfiguredFilter::index of the PT2 of kenngr.in_add_interface_filter_time (P-AXIS-00438), which has no
/// place among lr_param.add_interface.filter[i].
inline constexpr std::uint32_t interface_filter_time = 1;

}  // namespace axisc::machine
