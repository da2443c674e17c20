// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::cli::says {

extern Sentence const cannot_read;
extern Sentence const cannot_write;
extern Sentence const bad_choice;
extern Sentence const bad_count;
extern Sentence const option_stdin_filename;
extern Sentence const nc_program;
extern Sentence const runtime;
extern Sentence const unexpected;
extern Sentence const help_usage;
extern Sentence const help_options;
extern Sentence const help_options_heading;
extern Sentence const argument_inputs;
extern Sentence const option_help;
extern Sentence const option_version;
extern Sentence const option_lang;
extern Sentence const option_cycle_time;
extern Sentence const option_baseline;
extern Sentence const blocks_constant;
extern Sentence const no_velocities;
extern Sentence const no_interface_filter;

}  // namespace axisc::cli::says
