// A channel list: which axes move together, how programs call them, and which programs run without being called.
// Parameters P-CHAN.
#pragma once

#include "configuration/files.hpp"
#include "configuration/located_text.hpp"
#include "configuration/start_up_list.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::configuration {

/// `gruppe[0].achse[j]` or `spindel[i]`.
struct ChannelAxis {
  std::uint32_t index = 0;
  std::optional<ListCount> number;  ///< log_achs_nr: kopf.achs_nr of the axis
  std::optional<LocatedText> name;  ///< bezeichnung: what programs call it
};

/// A pair of coupled axes, by their numbers.
struct CoupledPair {
  std::uint32_t group = 0;
  std::uint32_t pair = 0;
  std::optional<ListCount> slave, master;
};

/// Axes, spindles and pairs by rising index; gaps are legal. Entries without a number are not configured.
struct ChannelList {
  std::optional<LocatedText> name;      ///< gruppe[0].bezeichnung
  std::vector<ChannelAxis> axes;        ///< of gruppe[0]
  std::optional<ListCount> axis_count;  ///< gruppe[0].achs_anzahl
  std::vector<ChannelAxis> spindles;
  std::optional<ListCount> spindle_count;  ///< spdl_anzahl
  std::vector<CoupledPair> pairs;          ///< synchro_data.koppel_gruppe[].paar[]
  std::vector<LocatedText> folders;        ///< path[i].dir: where programs are searched for
  std::vector<LocatedText>
      programs;  ///< that the control runs by itself: start_init_prog_file, m6_prog_file, …
};

[[nodiscard]] ChannelList read_channel_list(SourceText const& text, SourceId source);

/// The paths of the channel's own programs that are found from the start-up list on, in its folders or without them.
/// Exported folders often lack them, so that it is no mistake if one is not found.
[[nodiscard]] std::vector<std::string> found_programs(Files& files, std::string const& start_up,
                                                      ChannelList const& channel);

}  // namespace axisc::configuration
