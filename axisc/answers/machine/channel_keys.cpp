#include "axisc/answers/machine/channel_keys.hpp"

#include "configuration/machine_file.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/start_up_channels.hpp"

#include <algorithm>

namespace axisc {

namespace {

using validator::LoadedMachine;

void read_start_up(ChannelKeys& keys, LoadedMachine const& machine, SourceSet const& sources) {
  auto const& start_up = *machine.start_up;
  keys.default_channel_list = validator::default_channel_list(start_up);
  for (auto const& channel : start_up.channels) {
    if (!validator::look_ahead_of(start_up, channel.index, sources).function) continue;
    keys.look_ahead[channel.group] = machine.groups[channel.group].dynamics.look_ahead_blocks;
  }
}

void read_file(ChannelKeys& keys, LoadedMachine const& machine, SourceSet const& sources) {
  std::deque<Finding> known;
  auto const file = configuration::read_machine_file(sources, *machine.machine_file, known);
  for (std::size_t i = 0; i < std::min(file.groups.size(), keys.look_ahead.size()); ++i) {
    keys.look_ahead[i] = file.groups[i].look_ahead_blocks;
  }
  if (!file.default_channel_list) return;
  auto const path = validator::beside(machine.path, file.default_channel_list->text);
  bool const is_read =
      std::any_of(machine.other_lists.begin(), machine.other_lists.end(),
                  [&](validator::NamedList const& each) { return sources[each.list.source].name() == path; });
  if (is_read) keys.default_channel_list = path;
}

}  // namespace

ChannelKeys channel_keys_of(LoadedMachine const& machine, SourceSet const& sources) {
  ChannelKeys keys;
  keys.look_ahead.resize(machine.groups.size());
  if (machine.start_up) read_start_up(keys, machine, sources);
  if (machine.machine_file) read_file(keys, machine, sources);
  return keys;
}

}  // namespace axisc
