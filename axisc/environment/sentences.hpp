// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::says {

extern Sentence const cannot_read;
extern Sentence const cannot_write;
extern Sentence const bad_choice;
extern Sentence const bad_count;
extern Sentence const nc_program;
extern Sentence const runtime;
extern Sentence const unexpected;
extern Sentence const blocks_constant;
extern Sentence const no_velocities;
extern Sentence const no_interface_filter;

}  // namespace axisc::says
