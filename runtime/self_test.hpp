// The self-tests of an image: does this processor compute what the image's compiler computed?
#pragma once

#include "axisrt.h"
#include "runtime/filter_kernel.hpp"
#include "runtime/image_view.hpp"

namespace axisc::runtime {

/// Runs every filter's samples on its own states with the kernel of the cycle, and leaves the steady state
/// for 0.
[[nodiscard]] axisrt_status run_self_tests(ImageView const& view, Filter const* filters);

}  // namespace axisc::runtime
