// What kind of list was read: axis lists are checked, all others are left alone.
#pragma once

#include "configuration/list_kind.hpp"
#include "validator/values/readings.hpp"

namespace axisc::validator {

/// Cost: a look at the unknown names, of which the first hundred count; all names where these speak against an axis list.
[[nodiscard]] configuration::ListKind kind_of_list(SourceText const& source, grammar::AxisList const& list,
                                                   Readings const& readings);

}  // namespace axisc::validator
