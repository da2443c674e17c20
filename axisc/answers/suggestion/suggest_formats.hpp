// Output formats of `axisc suggest`.
#pragma once

#include "axisc/answers/suggestion/damping.hpp"
#include "axisc/answers/suggestion/suggestion.hpp"
#include "diagnostics/message.hpp"

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

[[nodiscard]] std::string suggest_text(Suggestion const& suggestion, Language language);
/// Which alternative was chosen, and its NC command.
[[nodiscard]] std::string chosen_text(Suggestion const& suggestion, std::size_t index, Language language);
/// `damping`: may be null.
[[nodiscard]] std::string suggest_json(Suggestion const& suggestion, DampingAnswer const* damping);

/// Where no filters are suggested.
[[nodiscard]] std::string suggest_json(SuggestionSubject const& subject, NoSuggestion const& none,
                                       DampingAnswer const& damping, tuning::Task const& task);

/// List lines under the names of the axes; axes that get the same lines are together.
[[nodiscard]] std::string fragments_text(std::vector<AxisLines> const& axes);
[[nodiscard]] nlohmann::ordered_json axes_json(std::vector<AxisLines> const& axes);

/// "48 Hz, 112 Hz".
[[nodiscard]] Wording resonances_text(tuning::Task const& task);

/// "balanced".
[[nodiscard]] std::string sense_name(tuning::Sense sense, Language language);

}  // namespace axisc
