// What `axisc explain` prints: the pages behind the codes, and the facts about parameters.
#pragma once

#include "diagnostics/message.hpp"
#include "schema/catalogue.hpp"
#include "validator/engine/rule.hpp"

#include <span>
#include <string>

namespace axisc {

/// One code as Markdown, with a heading of level `level` (1 to 3).
[[nodiscard]] std::string explain_rule(validator::Rule const& rule, std::size_t level, Language language);

/// Every code in one document; the English one is docs/rules.md in the repository.
[[nodiscard]] std::string explain_all(Language language);

/// One row of the catalogue as Markdown.
[[nodiscard]] std::string explain_parameter(schema::Catalogue const& catalogue,
                                            schema::Parameter const& parameter, Language language);

/// Parameters as a list, a line each.
[[nodiscard]] std::string list_parameters(std::span<schema::Parameter const* const> parameters,
                                          Language language);

/// The rules that foretell a message of the control, a line each.
[[nodiscard]] std::string explain_message(std::string const& number,
                                          std::span<validator::Rule const* const> rules, Language language);

/// Rules and parameters for other programs.
[[nodiscard]] std::string explain_json(schema::Catalogue const& catalogue,
                                       std::span<validator::Rule const* const> rules,
                                       std::span<schema::Parameter const* const> parameters,
                                       Language language);

}  // namespace axisc
