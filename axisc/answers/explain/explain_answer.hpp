// What codes, messages of the control and parameters mean, as an answer.
#pragma once

#include "presentation/document.hpp"
#include "schema/catalogue.hpp"
#include "validator/engine/rule.hpp"

#include <string>

namespace axisc {

struct ExplainQuestion {
  std::string word;  ///< a code, its name, a number, a parameter, a part of one, or a message of the control
  bool all = false;  ///< instead of a word: every code
  schema::Catalogue of_axes;  ///< with what schema files add
};

/// Failure for a word that means nothing, with what may have been meant.
[[nodiscard]] presentation::Document explain_answer(ExplainQuestion const& question);

/// One code, and one row of the catalogue.
[[nodiscard]] presentation::Document rule_answer(validator::Rule const& rule);
[[nodiscard]] presentation::Document parameter_answer(schema::Catalogue const& catalogue,
                                                      schema::Parameter const& parameter);

[[nodiscard]] presentation::Symbol severity_symbol(Severity severity);
/// Their sections; the id of a rule's is the code.
[[nodiscard]] presentation::Section rule_section(validator::Rule const& rule);
[[nodiscard]] presentation::Section parameter_section(schema::Catalogue const& catalogue,
                                                      schema::Parameter const& parameter);

}  // namespace axisc
