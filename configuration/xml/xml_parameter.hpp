// Names of elements in XML lists: the numbers of parameters with their indices, `P-AXIS-00008.0`.
#pragma once

#include "configuration/list_kind.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace axisc::configuration {

/// Whether an element is meant as a parameter of any kind of list: `P-AXIS-00016`, in any letter case.
[[nodiscard]] bool is_numbered(std::string_view element);

/// What a list of this kind calls the parameter: `getriebe[0].dynamik.a_max`. Where there are fewer indices than the name has,
/// the first ones are 0. None for numbers of other kinds, unknown ones, and every other name.
[[nodiscard]] std::optional<std::string> parameter_name(std::string_view element, ListKind kind);

}  // namespace axisc::configuration
