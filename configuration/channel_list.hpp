// A channel list: which axes move together, how programs call them, and which programs run without being
// called. Parameters P-CHAN.
#pragma once

#include "configuration/files.hpp"
#include "configuration/list_search.hpp"
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
  std::optional<LocatedText> name;  ///< bezeichnung: its name in programs
};

/// A pair of coupled axes, by their numbers.
struct CoupledPair {
  std::uint32_t group = 0;
  std::uint32_t pair = 0;
  std::optional<ListCount> slave, master;
};

/// A program that the control runs by itself, or instead of a G or M function.
struct ChannelProgram {
  std::string parameter;  ///< start_init_prog_file, m6_prog_file, …
  LocatedText file;
  /// streaming_prog_file: the lines come through an interface under this name, and the control opens no file.
  bool is_streamed = false;
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
  std::vector<ChannelProgram> programs;    ///< of a parameter that is set twice the last line counts
};

[[nodiscard]] ChannelList read_channel_list(SourceText const& text, SourceId source);
/// Programs that a channel does not name are those of the default list of all channels; its folders come
/// last.
void add_default_programs(ChannelList& channel, ChannelList const& defaults);

/// Where a program of the channel lies: found from the start-up list on, in the channel's folders or without
/// them.
[[nodiscard]] std::optional<FoundList> find_program(Files& files, std::string const& start_up,
                                                    ChannelList const& channel,
                                                    ChannelProgram const& program);

/// The paths of all the channel's own programs that are found.
[[nodiscard]] std::vector<std::string> found_programs(Files& files, std::string const& start_up,
                                                      ChannelList const& channel);

}  // namespace axisc::configuration
