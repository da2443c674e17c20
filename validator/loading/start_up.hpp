// The machine as described by a controller's start-up list and the lists that it names, or by a TwinCAT
// project.
#pragma once

#include "configuration/channel_list.hpp"
#include "configuration/list_search.hpp"
#include "configuration/real_time_list.hpp"
#include "configuration/start_up_list.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace axisc::validator {

enum class Sought : std::uint8_t {
  list,
  program,
  streamed_program,  ///< no file need be there
  unnamed_list       ///< an entry below a count that no line names
};

/// A list that the start-up list names or counts, or a program that a channel names, and where it was found.
struct ListSearch {
  configuration::LocatedText named;
  Sought sought = Sought::list;
  std::optional<configuration::FoundList> found;       ///< none where it is missing or cannot be read
  std::optional<configuration::FileError> error = {};  ///< why it cannot be read although it is there
  /// The kind that belongs here; none where any kind does.
  std::optional<configuration::ListKind> wanted = {};
  std::optional<configuration::ListKind> kind = {};  ///< of the file; none where nothing decides
};

struct StartUpChannel {
  std::uint32_t index = 0;  ///< i of sda_mds[i]
  configuration::ChannelList list;
  std::size_t group = 0;  ///< index into LoadedMachine::groups
};

/// A compensation list with the axis number that it names itself (kopf.achs_nr).
struct StartUpCompensation {
  configuration::CompensationEntry entry;
  std::optional<configuration::ListCount> own_axis;
};

struct StartUp {
  bool is_project = false;  ///< the lists are those inside a TwinCAT project, and there is no start-up list
  std::vector<SourceId>
      sources;  ///< the start-up list, and every list that was read in addition to those of the axes
  configuration::StartUpList list;
  configuration::RealTimeList real_time;
  std::vector<std::optional<configuration::LocatedText>>
      program_names;                    ///< of each of LoadedMachine::axes: DefaultProgName of a project
  std::vector<std::size_t> entries;     ///< of each of LoadedMachine::axes: index into list.axes
  std::deque<StartUpChannel> channels;  ///< those that the control reads, with a list that was found
  std::vector<StartUpCompensation> compensations;  ///< likewise
  std::vector<ListSearch> searches;                ///< in the order in which lists were looked for
};

/// True for the list that default_achs_mds names.
[[nodiscard]] inline bool is_default_list(StartUp const& start_up, ListSearch const& search) {
  return start_up.list.default_axis_list && start_up.list.default_axis_list->place == search.named.place;
}

}  // namespace axisc::validator
