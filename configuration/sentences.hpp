// Sentences that several sources share, in this folder and in those that use it.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::configuration::says {

extern Sentence const json_did_you_mean;
extern Sentence const json_known_keys;
extern Sentence const json_missing_key;
extern Sentence const json_cycle_time;
extern Sentence const json_write_number;
extern Sentence const json_repeated_value;
extern Sentence const xml_spelling;  ///< of a name in another letter case, or with a prefix

}  // namespace axisc::configuration::says
