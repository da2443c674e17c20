// What codes, messages of the control and parameters mean, as an answer.
#pragma once

#include "presentation/document.hpp"
#include "schema/catalogue.hpp"
#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <string>

namespace axisc {

struct ExplainQuestion {
  /// A code, its name, a number, a parameter, a part of one, a message of the control, or a word of NC
  /// programs that says how a path is driven.
  std::string word;
  bool all = false;           ///< instead of a word: every code
  schema::Catalogue of_axes;  ///< with what schema files add
};

/// Failure for a word that means nothing, with what may have been meant.
[[nodiscard]] presentation::Document explain_answer(ExplainQuestion const& question);

/// One code, one row of the catalogue, and one word of NC programs.
[[nodiscard]] presentation::Document rule_answer(validator::Rule const& rule);
[[nodiscard]] presentation::Document parameter_answer(schema::Catalogue const& catalogue,
                                                      schema::Parameter const& parameter);
[[nodiscard]] presentation::Document word_answer(schema::MotionWord const& word);

[[nodiscard]] presentation::Symbol severity_symbol(Severity severity);
/// Their sections; the id of a rule's is the code.
[[nodiscard]] presentation::Section rule_section(validator::Rule const& rule);
[[nodiscard]] presentation::Section parameter_section(schema::Catalogue const& catalogue,
                                                      schema::Parameter const& parameter);

}  // namespace axisc
