// Titles of rules in words, and the manuals that describe what they check.
#pragma once

#include "validator/engine/rule.hpp"

#include <vector>

namespace axisc::validator {

/// The heading of the rule's pages: "Delay too long". Cost: one table access.
[[nodiscard]] Page const& title(Rule const& rule);

/// "Axis filters, section 3.2": where the manuals describe the parameters that the rule looks at, and its NC
/// commands; each once. Empty for rules about other things.
[[nodiscard]] std::vector<Page> manual_sections(Rule const& rule);

}  // namespace axisc::validator
