// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::cli::says {

extern Sentence const one_output;

}  // namespace axisc::cli::says
