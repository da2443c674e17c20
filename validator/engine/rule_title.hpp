// Titles of rules in words.
#pragma once

#include "validator/engine/rule.hpp"

namespace axisc::validator {

/// The heading of the rule's pages: "Delay too long". Cost: one table access.
[[nodiscard]] Page const& title(Rule const& rule);

}  // namespace axisc::validator
