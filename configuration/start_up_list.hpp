// A controller's start-up list: which lists make its machine. Parameters P-STUP.
#pragma once

#include "configuration/list_kind.hpp"
#include "configuration/listed_values.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::configuration {

/// One entry of an array of lists: `achs_mds[2]`.
struct ListEntry {
  std::uint32_t index = 0;
  LocatedText file;  ///< as written
};

/// A compensation list and the number of the axis that it belongs to.
struct CompensationEntry {
  ListEntry list;
  std::optional<ListCount> axis;  ///< achs_kw_log_ax_nr[i]
};

/// A list that does not decide which axes there are.
struct OtherList {
  LocatedText file;
  std::optional<ListKind> kind;  ///< that belongs here; none where any kind does
};

/// The entries of each array by rising index; of an entry that is given twice the last line counts. Lines
/// without a file name are ignored.
struct StartUpList {
  std::vector<ListEntry> axes;                   ///< achs_mds[i]
  std::optional<ListCount> axis_count;           ///< zahl_mds
  std::optional<LocatedText> default_axis_list;  ///< default_achs_mds
  std::vector<ListEntry> channels;               ///< sda_mds[i]
  std::optional<ListCount> channel_count;        ///< kanal_anzahl
  std::optional<LocatedText> default_channel;    ///< default_sda_mds
  std::vector<CompensationEntry> compensations;  ///< achs_kw[i]
  std::optional<ListCount> compensation_count;   ///< zahl_kw
  std::optional<LocatedText> real_time;          ///< rtconf_lis
  std::optional<LocatedText> position_control;   ///< scheduling_position_controller
  std::vector<OtherList> others;                 ///< tools, offsets, variables, manual mode, hardware
};

/// True where the control reads the entry: its index is below the count, and a count that is missing is 0.
[[nodiscard]] bool is_read(ListEntry const& entry, std::optional<ListCount> const& count);

[[nodiscard]] StartUpList read_start_up_list(SourceText const& text, SourceId source);

/// Every list that a start-up list names, as written.
[[nodiscard]] std::vector<LocatedText const*> named_lists(StartUpList const& list);

/// True for text that names the lists of a machine: a line begins with one of the parameters that only
/// start-up lists have. Cost: a search through the bytes.
[[nodiscard]] bool looks_like_start_up_list(std::string_view bytes);

}  // namespace axisc::configuration
