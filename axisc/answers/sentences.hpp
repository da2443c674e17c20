// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::says {

extern Sentence const inspect_cycle_time;
extern Sentence const inspect_column_type;
extern Sentence const inspect_column_order;
extern Sentence const inspect_column_frequency;
extern Sentence const inspect_column_quality;
extern Sentence const inspect_column_share;
extern Sentence const inspect_column_delay;
extern Sentence const inspect_column_overshoot;
extern Sentence const inspect_column_peak_gain;
extern Sentence const inspect_delay_value;

}  // namespace axisc::says
