// What a machine says about its channels outside of their own lists, as a machine file writes it.
#pragma once

#include "validator/loading/loading.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ChannelKeys {
  std::optional<std::string> default_channel_list;       ///< its path
  std::vector<std::optional<std::uint32_t>> look_ahead;  ///< of each group; none: the lists or the default
};

/// From the start-up list, or from the machine file.
[[nodiscard]] ChannelKeys channel_keys_of(validator::LoadedMachine const& machine, SourceSet const& sources);

}  // namespace axisc
