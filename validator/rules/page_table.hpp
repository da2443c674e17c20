// The embedded pages and facts of the rules; the tables themselves are written by cmake/EmbedPages.cmake and
// cmake/RuleFacts.cmake when the program is built.
#pragma once

#include "diagnostics/page.hpp"
#include "validator/engine/rule_facts.hpp"

#include <span>

namespace axisc::validator {

/// One page per rule, in the order of the codes.
[[nodiscard]] std::span<Page const> page_table();
/// Their headings, in the same order.
[[nodiscard]] std::span<Page const> page_title_table();
/// Their facts, in the same order.
[[nodiscard]] std::span<RuleFacts const> facts_table();

}  // namespace axisc::validator
