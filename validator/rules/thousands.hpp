// Points between thousands, as in German: `500.000`.
#pragma once

#include "diagnostics/finding.hpp"

#include <string>

namespace axisc::validator {

/// Suggests both readings of `500.000` or `1.500.000`; false for any other number.
bool describe_thousands(Finding& finding, std::string const& value);

}  // namespace axisc::validator
