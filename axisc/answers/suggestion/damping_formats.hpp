// Output formats of what `axisc suggest --plant` says about Improved Position Control.
#pragma once

#include "axisc/answers/suggestion/damping.hpp"
#include "diagnostics/message.hpp"

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

/// What follows the filters.
[[nodiscard]] std::string damping_text(DampingAnswer const& answer, SuggestionSubject const& subject,
                                       tuning::Task const& task, Language language);

/// The number and the setting, of an answer that has one.
[[nodiscard]] std::string chosen_text(DampingAnswer const& answer, Language language);

/// The value of `position_control`.
[[nodiscard]] nlohmann::ordered_json damping_json(DampingAnswer const& answer, tuning::Task const& task);

}  // namespace axisc
