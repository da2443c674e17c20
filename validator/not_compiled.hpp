// Features that images cannot hold.
#pragma once

#include "diagnostics/finding.hpp"

namespace axisc::validator {

/// A feature that a list configures and that an image cannot hold yet; `compile` refuses then.
struct NotCompiled {
  Place place;
  Message feature;  ///< "the FIR filter of axis X"
};

}  // namespace axisc::validator
