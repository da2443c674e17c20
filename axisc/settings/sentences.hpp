// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::says {

extern Sentence const settings_build;

}  // namespace axisc::says
