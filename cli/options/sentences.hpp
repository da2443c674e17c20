// Sentences that several sources of this folder share.
#pragma once

#include "axisc/environment/sentences.hpp"

namespace axisc::cli::says {

using namespace axisc::says;

extern Sentence const help_usage;
extern Sentence const help_options;
extern Sentence const help_options_heading;
extern Sentence const argument_inputs;
extern Sentence const option_stdin_filename;
extern Sentence const option_help;
extern Sentence const option_version;
extern Sentence const option_lang;
extern Sentence const option_cycle_time;
extern Sentence const option_baseline;
extern Sentence const one_output;

}  // namespace axisc::cli::says
