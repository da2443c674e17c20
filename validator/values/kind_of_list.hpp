// The kind of a list, judged by its content.
#pragma once

#include "configuration/list_kind.hpp"
#include "validator/values/line_values.hpp"

namespace axisc::validator {

/// None where nothing decides. The list was read as an axis list. Cost: a look at the unknown names, of which
/// the first hundred count; all names where these speak against an axis list.
[[nodiscard]] std::optional<configuration::ListKind> kind_of_list(SourceText const& source,
                                                                  grammar::AxisList const& list,
                                                                  LineValues const& line_values);

}  // namespace axisc::validator
