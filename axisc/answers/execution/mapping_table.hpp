// Which columns of a recording an answer used, and how.
#pragma once

#include "axisc/answers/execution/recorded_scale.hpp"
#include "presentation/document.hpp"

#include <string>
#include <vector>

namespace axisc {

/// A row each: `signals` are for people and programs, such as the names of axes.
[[nodiscard]] presentation::Table mapping_table(std::vector<std::string> const& signals,
                                                std::vector<MappedColumn> const& columns);

}  // namespace axisc
