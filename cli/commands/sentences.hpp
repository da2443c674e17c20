// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::cli::says {

extern Sentence const bad_number;
extern Sentence const argument_input;
extern Sentence const argument_image;
extern Sentence const argument_machine_or_image;
extern Sentence const option_at;
extern Sentence const option_level;
extern Sentence const option_setpoint_column;
extern Sentence const option_filtered_column;
extern Sentence const option_group;

}  // namespace axisc::cli::says
