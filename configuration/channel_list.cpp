#include "configuration/channel_list.hpp"

#include "configuration/listed_values.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace axisc::configuration {
namespace {

constexpr std::string_view streamed_program = "streaming_prog_file";
constexpr std::array<std::string_view, 16> program_names = {
    "start_init_prog_file", "final_prog_file", "m6_prog_file",  "d_prog_file",
    streamed_program,       "g80_prog_file",   "g81_prog_file", "g82_prog_file",
    "g83_prog_file",        "g84_prog_file",   "g85_prog_file", "g86_prog_file",
    "g87_prog_file",        "g88_prog_file",   "g89_prog_file", "g800_prog_file[]"};

/// The entry for which `is_it` holds, which is new at the end where there was none.
template <typename Entry, typename Is>
Entry& entry_where(std::vector<Entry>& entries, Entry added, Is is_it) {
  auto const at = std::find_if(entries.begin(), entries.end(), is_it);
  return at != entries.end() ? *at : entries.emplace_back(std::move(added));
}

ChannelAxis& axis_at(std::vector<ChannelAxis>& axes, std::uint32_t index) {
  return entry_where(axes, ChannelAxis{.index = index, .number = {}, .name = {}},
                     [index](ChannelAxis const& axis) { return axis.index == index; });
}

std::optional<LocatedText> as_name(ListedValue const& listed) {
  if (listed.value.text.empty()) return std::nullopt;
  return listed.value;
}

class ChannelReader {
 public:
  ChannelList read(std::vector<ListedValue> const& values) && {
    for (ListedValue const& listed : values) {
      if (!read_axis(listed) && !read_pair(listed)) read_rest(listed);
    }
    finish(channel_.axes);
    finish(channel_.spindles);
    std::erase_if(channel_.pairs, [](CoupledPair const& pair) { return !pair.slave || !pair.master; });
    return std::move(channel_);
  }

 private:
  bool read_axis(ListedValue const& listed) {
    if (auto const at = match_name(listed.name, "gruppe[].achse[].log_achs_nr")) {
      if ((*at)[0] == 0) axis_at(channel_.axes, (*at)[1]).number = as_count(listed);
    } else if (auto const named = match_name(listed.name, "gruppe[].achse[].bezeichnung")) {
      if ((*named)[0] == 0) axis_at(channel_.axes, (*named)[1]).name = as_name(listed);
    } else if (auto const spindle = match_name(listed.name, "spindel[].log_achs_nr")) {
      axis_at(channel_.spindles, (*spindle)[0]).number = as_count(listed);
    } else if (auto const called = match_name(listed.name, "spindel[].bezeichnung")) {
      axis_at(channel_.spindles, (*called)[0]).name = as_name(listed);
    } else {
      return false;
    }
    return true;
  }

  bool read_pair(ListedValue const& listed) {
    auto const slave = match_name(listed.name, "synchro_data.koppel_gruppe[].paar[].log_achs_nr_slave");
    auto const master = match_name(listed.name, "synchro_data.koppel_gruppe[].paar[].log_achs_nr_master");
    if (!slave && !master) return false;
    NameIndices const at = slave ? *slave : *master;
    CoupledPair& pair =
        entry_where(channel_.pairs, CoupledPair{.group = at[0], .pair = at[1], .slave = {}, .master = {}},
                    [&](CoupledPair const& each) { return each.group == at[0] && each.pair == at[1]; });
    (slave ? pair.slave : pair.master) = as_count(listed);
    return true;
  }

  void read_rest(ListedValue const& listed) {
    auto const group = match_name(listed.name, "gruppe[].bezeichnung");
    if (group && (*group)[0] == 0) channel_.name = as_name(listed);
    auto const count = match_name(listed.name, "gruppe[].achs_anzahl");
    if (count && (*count)[0] == 0) channel_.axis_count = as_count(listed);
    if (match_name(listed.name, "spdl_anzahl")) channel_.spindle_count = as_count(listed);
    if (match_name(listed.name, "path[].dir")) channel_.folders.push_back(listed.value);
    bool const is_program =
        std::any_of(program_names.begin(), program_names.end(),
                    [&](std::string_view pattern) { return match_name(listed.name, pattern).has_value(); });
    if (is_program) read_program(listed);
  }

  void read_program(ListedValue const& listed) {
    std::erase_if(channel_.programs, [&](ChannelProgram const& known) {
      return ascii::equal_ignoring_case(known.parameter, listed.name);
    });
    if (listed.value.text.empty()) return;
    channel_.programs.push_back({.parameter = std::string(listed.name),
                                 .file = listed.value,
                                 .is_streamed = match_name(listed.name, streamed_program).has_value()});
  }

  /// Number 0 means that there is no axis.
  static void finish(std::vector<ChannelAxis>& axes) {
    std::erase_if(axes, [](ChannelAxis const& axis) { return !axis.number || axis.number->number == 0; });
    std::sort(axes.begin(), axes.end(),
              [](ChannelAxis const& a, ChannelAxis const& b) { return a.index < b.index; });
  }

  ChannelList channel_;
};

}  // namespace

ChannelList read_channel_list(SourceText const& text, SourceId source) {
  return ChannelReader().read(listed_values(text, source));
}

void add_default_programs(ChannelList& channel, ChannelList const& defaults) {
  for (ChannelProgram const& program : defaults.programs) {
    bool const is_set =
        std::any_of(channel.programs.begin(), channel.programs.end(), [&](ChannelProgram const& own) {
          return ascii::equal_ignoring_case(own.parameter, program.parameter);
        });
    if (!is_set) channel.programs.push_back(program);
  }
  channel.folders.insert(channel.folders.end(), defaults.folders.begin(), defaults.folders.end());
}

std::optional<FoundList> find_program(Files& files, std::string const& start_up, ChannelList const& channel,
                                      ChannelProgram const& program) {
  auto found = find_list(files, start_up, program.file.text);
  for (auto folder = channel.folders.begin(); !found && folder != channel.folders.end(); ++folder) {
    found = find_list(files, start_up, folder->text + "/" + program.file.text);
  }
  return found;
}

std::vector<std::string> found_programs(Files& files, std::string const& start_up,
                                        ChannelList const& channel) {
  std::vector<std::string> paths;
  for (ChannelProgram const& program : channel.programs) {
    if (auto found = find_program(files, start_up, channel, program)) paths.push_back(std::move(found->path));
  }
  return paths;
}

}  // namespace axisc::configuration
