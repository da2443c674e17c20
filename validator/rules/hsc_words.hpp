// Places that the rules about HSC filters point to.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/views/filter_view.hpp"

namespace axisc::validator::checks {

/// Points at the prototype, where a list sets it: as the line that chooses HSC, and as one of several HSC
/// filters.
void relate_prototype(Finding& finding, FilterView const& filter);
void relate_hsc_filter(Finding& finding, FilterView const& filter);

}  // namespace axisc::validator::checks
