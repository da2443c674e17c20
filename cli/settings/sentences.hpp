// What several sources of this folder say.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::cli::says {

extern Sentence const settings_build;

}  // namespace axisc::cli::says
