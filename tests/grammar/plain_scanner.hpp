// The language of axis lists once more, as a plain scanner by hand: an oracle for the grammar, written
// without it.
#pragma once

#include "grammar/axis_list.hpp"

#include <string_view>

namespace axisc::test {

/// What parse_axis_list() promises.
[[nodiscard]] grammar::AxisList scan_axis_list(std::string_view bytes, bool windows_1252);

}  // namespace axisc::test
