// Writes the catalogues of all kinds of lists but axis lists as constant tables in C++.
#pragma once

#include "schema/parameter_row.hpp"

#include <map>
#include <string>
#include <vector>

namespace axisc::schema::generator {

using KindRows = std::map<ListKind, std::vector<ParameterRow>>;

/// The text of kind_tables.inc, which kind_tables.cpp includes. `axis_rows` tell which names are in axis
/// lists too.
[[nodiscard]] std::string write_kinds(KindRows const& kinds, std::vector<ParameterRow> const& axis_rows);

}  // namespace axisc::schema::generator
