// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::motion::says {

extern Sentence const cannot_simulate;

}  // namespace axisc::motion::says
