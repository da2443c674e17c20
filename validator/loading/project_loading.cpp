#include "configuration/project_file.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace axisc::validator {
namespace {

using configuration::ListKind;
using configuration::ProjectList;

/// An axis has a number, or a place in a channel.
bool is_default_list(ProjectList const& named, LoadedList const& list, SourceText const& source) {
  if (named.program_name || named.default_channel || named.default_index) return false;
  return std::none_of(list.tree.assignments.begin(), list.tree.assignments.end(),
                      [&](grammar::Assignment const& line) {
                        return configuration::match_name(source.slice(line.name), "kopf.achs_nr") &&
                               source.slice(line.value) != "0";
                      });
}

}  // namespace

void Loader::load_project(SourceId source) {
  configuration::Project const project = configuration::read_project(sources_, source, machine_.findings);
  StartUp& start_up = machine_.start_up.emplace();
  start_up.is_project = true;
  start_up.real_time = project.real_time;
  machine_.cycle_time = project.real_time.cycle_time;
  // Every list of a project is read.
  constexpr std::uint32_t all = std::numeric_limits<std::uint32_t>::max();
  start_up.list.axis_count = {.number = all, .place = {.source = source, .span = {}}};
  start_up.list.channel_count = start_up.list.axis_count;

  std::vector<SourceId> windows;
  for (ProjectList const& list : project.lists) {
    windows.push_back(sources_.add(SourceText(
        machine_.path, Window{.file = sources_[source], .span = list.span, .encoding = project.encoding})));
  }
  auto const lists_of_axes =
      std::count_if(project.lists.begin(), project.lists.end(),
                    [](ProjectList const& list) { return list.kind == ListKind::axis; });
  std::vector<std::pair<ProjectList const*, std::size_t>> axes;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    ProjectList const& named = project.lists[i];
    if (named.kind != ListKind::axis) continue;
    auto const list = project_axis_list(start_up, named, windows[i]);
    if (!list) continue;
    LoadedList& loaded = machine_.lists[*list].list;
    if (lists_of_axes > 1 && !machine_.default_list && is_default_list(named, loaded, sources_[windows[i]])) {
      machine_.default_list = list;
      loaded.is_default_list = true;
    } else {
      axes.emplace_back(&named, *list);
    }
  }
  std::vector<ProjectList const*> of_axes;
  for (auto const& [named, list] : axes) {
    add_axis(list, std::nullopt);
    start_up.entries.push_back(start_up.list.axes.size());
    start_up.list.axes.push_back(
        {.index = static_cast<std::uint32_t>(start_up.list.axes.size()), .file = named->name});
    start_up.program_names.push_back(named->program_name);
    of_axes.push_back(named);
  }
  for (std::size_t i = 0; i < windows.size(); ++i) {
    ProjectList const& named = project.lists[i];
    if (named.kind == ListKind::axis) continue;
    if (named.kind != ListKind::channel) {
      // It is not documented which lists real projects have in these elements, so the lines decide.
      auto const said = configuration::decided_kind(sources_[windows[i]]);
      add_other_list(windows[i], said && said != ListKind::axis ? *said : named.kind, named.name.text);
      continue;
    }
    start_up.sources.push_back(windows[i]);
    add_other_list(windows[i], ListKind::channel, named.name.text);
    start_up.list.channels.push_back(
        {.index = static_cast<std::uint32_t>(start_up.channels.size()), .file = named.name});
    add_channel(start_up, start_up.list.channels.back().index, windows[i]);
    LoadedGroup& group = machine_.groups.back();
    if (group.name.empty()) group.name = named.name.text;
  }
  group_by_defaults(start_up, of_axes);
  name_axes(start_up);
}

std::optional<std::size_t> Loader::project_axis_list(StartUp& start_up, ProjectList const& named,
                                                     SourceId source) {
  std::size_t const list = add_source(source, named.name.text);
  ListKind const kind = machine_.lists[list].list.kind;
  if (kind == ListKind::axis) return list;
  start_up.searches.push_back({.named = named.name,
                               .found = configuration::FoundList{.path = machine_.path},
                               .wanted = ListKind::axis,
                               .kind = kind});
  machine_.complete = false;
  machine_.knows_all_axes = false;
  return std::nullopt;
}

/// Where no channel list names axes, each axis names its channel.
void Loader::group_by_defaults(StartUp const& start_up, std::vector<ProjectList const*> const& axes) {
  bool const are_named =
      std::any_of(start_up.channels.begin(), start_up.channels.end(), [](StartUpChannel const& channel) {
        return !channel.list.axes.empty() || !channel.list.spindles.empty();
      });
  if (are_named) return;
  std::map<std::uint32_t, std::vector<std::size_t>> by_channel;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    auto const& channel = axes[axis]->default_channel;
    bool const moves = machine_.axes[axis].type != machine::AxisType::spindle;
    if (channel && channel->number != 0 && moves) by_channel[channel->number].push_back(axis);
  }
  for (auto& [channel, members] : by_channel) {
    if (channel <= machine_.groups.size()) {
      machine_.groups[channel - 1].axes = std::move(members);
    } else {
      machine_.groups.push_back({.name = {}, .axes = std::move(members), .programs = {}});
    }
  }
}

}  // namespace axisc::validator
