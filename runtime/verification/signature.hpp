// The signature after an image.
#pragma once

#include "axisrt.h"

namespace axisc::runtime {

/// AXISRT_OK where none is demanded, or where the caller's function finds it right. Reads the header and the
/// trailer alone: the image's content is not trusted before.
[[nodiscard]] axisrt_status check_signature(axisrt_config const& config);

}  // namespace axisc::runtime
