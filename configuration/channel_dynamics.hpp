// What channel lists and start-up lists say about how fast a channel drives its path.
#pragma once

#include "configuration/listed_values.hpp"
#include "configuration/machine/path_dynamics.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::configuration {

/// The size of the look-ahead buffer as lists write it: the function FCT_LOOK_AHEAD_… (P-CHAN-00650,
/// P-STUP-00070), and the number of blocks that counts with FCT_LOOK_AHEAD_CUSTOM alone (P-CHAN-00653,
/// P-STUP-00071).
struct ListedLookAhead {
  std::optional<LocatedText> function;
  std::optional<std::uint32_t> blocks;
};

/// A parameter that changes how the control plans, but no plan of ours: P-CHAN-00190, 00230, 00245.
struct UncomputedValue {
  std::string_view number;  ///< "P-CHAN-00190"
  Place name_place;
};

/// Everything that is said about the motion of one channel. What a list leaves open is unchanged.
struct ListedDynamics {
  machine::ChannelDynamics dynamics;
  ListedLookAhead look_ahead;
  std::vector<UncomputedValue> uncomputed;  ///< those that are not 0
  std::optional<Place> slope_place;         ///< of the value of P-CHAN-00071
};

/// Takes what a channel list says: of a parameter that is set twice the last line counts. Values that are no
/// value of the parameter are left out; they are findings of the checks of lists.
void read_channel_dynamics(std::vector<ListedValue> const& values, ListedDynamics& listed);

/// What a start-up list says about the buffer of `configuration.channel[channel]`.
void read_look_ahead(std::vector<ListedValue> const& values, std::uint32_t channel, ListedLookAhead& listed);

/// Blocks in the buffer: LOW 30, HIGH 190, CUSTOM 10 to 500, to 10000 with the slope STEP; otherwise
/// `standard`.
[[nodiscard]] std::uint32_t look_ahead_blocks(ListedLookAhead const& listed, machine::Slope slope,
                                              std::uint32_t standard);

}  // namespace axisc::configuration
