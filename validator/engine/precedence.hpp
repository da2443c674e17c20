// One mistake, one message: decides which of several findings is kept.
#pragma once

#include "validator/engine/report.hpp"

#include <cstdint>
#include <vector>

namespace axisc::validator {

/// The findings that are kept, by their number.
using Standing = std::vector<std::uint32_t>;

/// Drops findings of rules that another finding on the same filter replaces (`silenced_by`).
void drop_replaced(ReportedFindings const& reported, Standing& standing);

/// Sorts by place and code, else in the order of reporting; merge_shared() and keep_highest_per_token() need
/// this order.
void put_in_order(ReportedFindings const& reported, Standing& standing);

/// Findings of one rule at one place, seen from several axes that share a list, become one.
void merge_shared(ReportedFindings& reported, Standing& standing);

/// Of findings whose places overlap only one is kept: errors before warnings before notes, then by the rule's
/// Precedence, then the one of the lower code.
void keep_highest_per_token(ReportedFindings const& reported, Standing& standing);

/// The order of every output: by source in input order, then line, then column, then code; equal ones keep
/// their order.
void put_in_output_order(ReportedFindings const& reported, Standing& standing);

}  // namespace axisc::validator
