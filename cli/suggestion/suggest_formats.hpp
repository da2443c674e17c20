// Output formats of `axisc suggest`.
#pragma once

#include "cli/suggestion/suggestion.hpp"
#include "diagnostics/message.hpp"

#include <string>

namespace axisc::cli {

[[nodiscard]] std::string suggest_text(Suggestion const& suggestion, Language language);
[[nodiscard]] std::string suggest_json(Suggestion const& suggestion);

/// "balanced".
[[nodiscard]] std::string sense_name(tuning::Sense sense, Language language);

}  // namespace axisc::cli
