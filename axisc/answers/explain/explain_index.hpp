// Ways to the rules for people who do not know their codes.
#pragma once

#include "presentation/document.hpp"
#include "schema/catalogue.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace axisc {

/// Tables by symptom, parameter, message of the control and code, each with links to the sections of the
/// rules. For people alone.
[[nodiscard]] std::vector<presentation::Block> rule_index(schema::Catalogue const& of_axes);

/// A word of RuleFacts::symptoms in words; none for others.
[[nodiscard]] std::optional<presentation::Words> symptom_text(std::string_view symptom);

}  // namespace axisc
