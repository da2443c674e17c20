// Sentences that several sources of this folder use.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::validator::says {

extern Sentence const parameter_fix;
extern Sentence const parameter_values;
extern Sentence const filter_reaction_off;
extern Sentence const filter_reaction_refused;
extern Sentence const filter_value_ignored;
extern Sentence const kernel_reaction_not_active;
extern Sentence const group_axis_delay;
extern Sentence const group_axis_shares;
extern Sentence const group_axis_after_filters;
extern Sentence const group_help_same;
extern Sentence const fir_type_here;
extern Sentence const undocumented_reaction;

}  // namespace axisc::validator::says
