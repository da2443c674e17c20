// One mistake, one message: which of several findings stands.
#pragma once

#include "validator/engine.hpp"

#include <vector>

namespace axisc::validator {

/// Drops findings of rules that another finding on the same filter replaces (`silenced_by`).
void drop_replaced(std::vector<RawFinding>& findings);

/// Findings of one rule at one place, seen from several axes that share a list, become one.
void merge_shared(std::vector<RawFinding>& findings);

/// Of findings whose places overlap only the highest stays: errors before warnings before notes; then AX1, AX4, AX3
/// (range errors before unused or rounded), AX2002/2003/2004/2007/2015, the rest of AX2, AX2005; then the lower code.
void keep_highest_per_token(std::vector<RawFinding>& findings);

}  // namespace axisc::validator
