// Sentences that several sources of this folder use.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::validator::says {

extern Sentence const parameter_did_you_mean;
extern Sentence const filter_reaction_inactive;
extern Sentence const filter_reaction_clipped;
extern Sentence const cycle_time_assumed_note;
extern Sentence const control_defaults;
extern Sentence const unnamed_list;
extern Sentence const milliseconds_meant;
extern Sentence const program_reaction_aborted;
extern Sentence const guard_stops_motion;

}  // namespace axisc::validator::says
