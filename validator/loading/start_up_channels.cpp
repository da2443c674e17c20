#include "validator/loading/start_up_channels.hpp"

#include "configuration/listed_values.hpp"

#include <algorithm>

namespace axisc::validator {

std::optional<std::string> default_channel_list(StartUp const& start_up) {
  auto const& named = start_up.list.default_channel;
  if (!named) return std::nullopt;
  auto const search = std::find_if(
      start_up.searches.begin(), start_up.searches.end(),
      [&named](ListSearch const& each) { return each.found && each.named.place == named->place; });
  return search == start_up.searches.end() ? std::nullopt : std::optional(search->found->path);
}

configuration::ListedLookAhead look_ahead_of(StartUp const& start_up, std::uint32_t channel,
                                             SourceSet const& sources) {
  configuration::ListedLookAhead listed;
  if (start_up.is_project) return listed;
  SourceId const list = start_up.sources.front();
  configuration::read_look_ahead(configuration::listed_values(sources[list], list), channel, listed);
  return listed;
}

}  // namespace axisc::validator
