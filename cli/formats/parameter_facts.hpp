// Facts about a row of the catalogue from other sources: rules, manuals, number formats.
#pragma once

#include "diagnostics/message.hpp"
#include "schema/catalogue.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

/// Codes of the rules that check the parameter, "AX2005": those whose page names it, and those that follow from the
/// row.
[[nodiscard]] std::vector<std::string> rules_about(schema::Parameter const& parameter);

/// The default as documented, except that 3.000000e+001 is 30; empty if there is none.
[[nodiscard]] std::string default_text(schema::Parameter const& parameter);

/// Where the manuals describe it; empty for parameters outside the filters.
[[nodiscard]] std::string manual_section(schema::Parameter const& parameter, Language language);

}  // namespace axisc::cli
