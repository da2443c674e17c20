// A misspelt `Ende`.
#pragma once

#include "validator/engine/rule.hpp"

namespace axisc::validator {

/// Describes the problem as a misspelt end marker; false if it is unlikely to be one: nothing may follow it.
bool describe_end_marker(Finding& finding, ListContext const& context, grammar::Problem const& problem);

}  // namespace axisc::validator
