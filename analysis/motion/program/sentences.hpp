// Sentences that several sources of this folder share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::motion::says {

extern Sentence const not_simulated;
extern Sentence const cannot_simulate;
extern Sentence const cannot_simulate_here;
extern Sentence const cannot_simulate_beside_dwell;
extern Sentence const cannot_simulate_twice;
extern Sentence const cannot_simulate_open;
extern Sentence const cannot_simulate_depth;

}  // namespace axisc::motion::says
