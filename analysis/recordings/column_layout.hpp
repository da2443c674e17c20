// Columns of a text without a scope's table.
#pragma once

#include "analysis/recordings/layout.hpp"

#include <vector>

namespace axisc::recordings {

/// Columns that a line of the header names. Names that begin with "time" or "zeit" are times of the columns
/// after them, in ms or in s ("_s", "[s]") if they say so; without one, a row is a cycle. Without names the
/// rows decide: pairs of time and value, or one time and values, or values alone; `rows` are the first of
/// them.
[[nodiscard]] Layout column_layout(std::vector<TextLine> const& header, std::vector<TextLine> const& rows);

}  // namespace axisc::recordings
