// Facts about a row of the catalogue from other sources: rules, manuals, number formats.
#pragma once

#include "diagnostics/message.hpp"
#include "schema/catalogue.hpp"
#include "validator/views/units_text.hpp"

#include <string>
#include <vector>

namespace axisc {

/// Codes of the rules that look at the parameter's value, "AX2005".
[[nodiscard]] std::vector<std::string> rules_about(schema::Parameter const& parameter);

/// Its ranges by the type of its filter, and those that depend on the cycle time T: "`PT1`, `PT2`: T ≤ value".
[[nodiscard]] std::vector<std::string> ranges_by_type(schema::Parameter const& parameter, Language language);

/// "µm/s", "0.0001 °", in German "0,0001 °".
[[nodiscard]] std::string unit_name(std::string_view unit, Language language);

using validator::default_text;

/// Where the manuals describe it; empty for parameters outside the filters.
[[nodiscard]] std::string manual_section(schema::Parameter const& parameter, Language language);

}  // namespace axisc
