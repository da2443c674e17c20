// The words of schema files: types, names, numbers of parameters, defaults.
#pragma once

#include "schema/parameter_row.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::cli {

/// "UNS08".
[[nodiscard]] std::optional<schema::DataType> parse_data_type(std::string_view word);
/// All of them, separated by commas.
[[nodiscard]] std::string data_type_names();

/// `getriebe[].dynamik.vb_max`: as in lists, with [] for an index, two of them at most.
[[nodiscard]] bool is_parameter_pattern(std::string_view name);

/// 140 of "P-AXIS-00140".
[[nodiscard]] std::optional<std::uint16_t> parse_p_axis(std::string_view text);

/// Whether `text` can be the default of a parameter with the row's type and symbols.
[[nodiscard]] bool is_default_of(schema::ParameterRow const& row, std::string const& text);

}  // namespace axisc::cli
