// What is known about a rule besides its page: since when there is one, where its contents come from, and
// where it is silent on purpose. Each rule's folder has it as facts.json.
#pragma once

#include "diagnostics/page.hpp"
#include "diagnostics/wording.hpp"
#include "validator/engine/rule.hpp"

#include <span>
#include <string_view>

namespace axisc::validator {

/// The pages are Markdown, one or two sentences; empty: there is nothing to say.
struct RuleFacts {
  /// Version of axisc that had the rule first; "unreleased".
  std::string_view since;
  /// What a person observes who has the mistake: "no-effect". The words are in explain_index.cpp.
  std::span<std::string_view const> symptoms;
  /// Places that document what the rule demands:
  /// - "axis-filters 2.1.8", "fir-filters 5", "position-control 4.2": section of a manual,
  /// - "tf5200_diagnosis/258487947 50663": page of the manual online, with what it is about: the number of a
  ///   message, a parameter, a word of NC programs, or nothing,
  /// - "message 110583": the control's text of a message, which no page describes,
  /// - "vendor-lists", "vendor-metadata": what the vendor's lists and descriptions of parameters show.
  std::span<std::string_view const> sources;
  Page reading;     ///< what the sources leave open, and the rule takes for granted
  Page own;         ///< why there is the rule, where no source demands it
  Page exceptions;  ///< where the rule is silent on purpose
};

/// Cost: one table access.
[[nodiscard]] RuleFacts const& facts(Rule const& rule);

/// A place of `sources` in words: "Axis filters, section 2.1.8". Empty for one of another form.
[[nodiscard]] Wording source_text(std::string_view source);

}  // namespace axisc::validator
