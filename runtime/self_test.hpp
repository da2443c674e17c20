// The self-tests of an image: does this processor compute what the image's compiler computed?
#pragma once

#include "axisrt.h"
#include "runtime/runtime_object.hpp"
#include "runtime/verification/image_view.hpp"

namespace axisc::runtime {

/// Runs every filter's samples on its own states with the kernel of the cycle, and every linear-phase
/// kernel's on a slot that may execute it; leaves the steady state for 0, and every slot switched as it was.
[[nodiscard]] axisrt_status run_self_tests(ImageView const& view, axisrt const& runtime);

}  // namespace axisc::runtime
