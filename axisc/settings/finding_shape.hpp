// The shape of a finding as `--format json` and `--format jsonl` write it, for its JSON schema.
#pragma once

#include "configuration/json_shape.hpp"

namespace axisc {

extern configuration::JsonShape const finding_shape;

}  // namespace axisc
