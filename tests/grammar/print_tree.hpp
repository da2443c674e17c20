// Trees as text, one line per assignment, problem and directive, so that tests can say what they expect.
#pragma once

#include "grammar/axis_list.hpp"

#include <string>
#include <string_view>

namespace axisc::test {

/// `bytes` is what was parsed. Control characters are written as \xNN.
[[nodiscard]] std::string print_tree(grammar::AxisList const& list, std::string_view bytes);

[[nodiscard]] std::string_view name_of(grammar::ValueKind kind);
[[nodiscard]] std::string_view name_of(grammar::ProblemKind kind);

}  // namespace axisc::test
