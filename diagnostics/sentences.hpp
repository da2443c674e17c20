// Sentences that several sources share, in this folder and in those that use it.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::says {

extern Sentence const word_error;
extern Sentence const word_warning;
extern Sentence const word_note;
extern Sentence const word_control;
extern Sentence const word_help;
extern Sentence const word_fix;
extern Sentence const control_message;
extern Sentence const control_messages;

}  // namespace axisc::says
