// What a start-up list says about the channels beside their lists.
#pragma once

#include "configuration/channel_dynamics.hpp"
#include "diagnostics/source_text.hpp"
#include "validator/loading/start_up.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::validator {

/// The path of the list that default_sda_mds names; none where it was not found.
[[nodiscard]] std::optional<std::string> default_channel_list(StartUp const& start_up);

/// The look-ahead of a channel (P-STUP-00070, 00071); a project says nothing.
[[nodiscard]] configuration::ListedLookAhead look_ahead_of(StartUp const& start_up, std::uint32_t channel,
                                                           SourceSet const& sources);

}  // namespace axisc::validator
