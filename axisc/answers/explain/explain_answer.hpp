// What codes, messages of the control, parameters, words of NC programs and topics mean, as an answer.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "presentation/document.hpp"
#include "schema/catalogue.hpp"
#include "schema/lookup/lookup.hpp"
#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace axisc {

struct ExplainQuestion {
  /// Whatever a person types: a code, its name, a number, a parameter, a part of one, a message of the
  /// control, its text with the number, a word of NC programs, or words for what they mean.
  std::string word;
  bool all = false;           ///< instead of a word: every code
  schema::Catalogue of_axes;  ///< with what schema files add
};

/// The page of what was meant, or everything that may have been meant, best first. Failure for a word that
/// means nothing, with what may have been meant.
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
