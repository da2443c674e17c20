#include "axisc/answers/difference/difference_answer.hpp"

#include "axisc/answers/difference/difference_parts.hpp"
#include "axisc/answers/labels.hpp"

#include <algorithm>
#include <map>

namespace axisc::says {

constexpr Sentence compared{"{before} → {after}", "{before} → {after}"};
constexpr Sentence nothing{"{before} and {after} mean the same", "{before} und {after} bedeuten dasselbe"};
constexpr Sentence after{"after", "nachher"};
constexpr Sentence present{"present", "vorhanden"};
constexpr Sentence spindles{"spindles", "Spindeln"};
constexpr Sentence couplings{"coupled (slave = master)", "gekoppelt (Slave = Master)"};
constexpr Sentence programs{"programs", "Programme"};
constexpr Sentence other_content{"{program} (other content)", "{program} (anderer Inhalt)"};
constexpr Sentence more{"{first}, {next}", "{first}, {next}"};
constexpr Sentence gantry{"gantry of {master}: slaves", "Gantry von {master}: Slaves"};
constexpr Sentence restart{"after a restart of the control: {parameters}",
                           "erst nach einem Neustart der Steuerung: {parameters}"};
constexpr Sentence no_restart{
    "none of the changed parameters is documented to need a restart of the control",
    "für keinen der geänderten Parameter ist ein Neustart der Steuerung dokumentiert"};
constexpr Sentence same_list{
    "both sides read {list}, because both start-up lists lead to it; to compare a copy of a folder, keep the "
    "folder's name: backup/listen beside listen, not backup",
    "beide Seiten lesen {list}, weil beide Hochlauflisten dorthin führen; um die Kopie eines Ordners zu "
    "vergleichen, den Namen des Ordners behalten: sicherung/listen neben listen, nicht sicherung"};
constexpr Sentence other_channels{"channels that differ: {channels}",
                                  "Kanäle, die sich unterscheiden: {channels}"};
constexpr Sentence set_to_default{
    "left out, as they only write out a default: {count} (--all shows them)",
    "weggelassen, weil sie nur einen Standardwert ausschreiben: {count} (--all zeigt sie)"};
constexpr Sentence own{"left out, as each axis has its own: {parameters} (--all shows them)",
                       "weggelassen, weil jede Achse eigene hat: {parameters} (--all zeigt sie)"};
constexpr Sentence no_effects{"what this does to the axes is left out, because a list has errors",
                              "was das mit den Achsen macht, fehlt, weil eine Liste Fehler hat"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Words title_of(ShownDifference const& shown) {
  auto const& difference = shown.difference;
  if (difference.empty()) return {says::nothing, {{"before", shown.before}, {"after", shown.after}}};
  if (difference.of_one_machine) return as_given(difference.before.input);
  return {says::compared, {{"before", shown.before}, {"after", shown.after}}};
}

Names names_of(std::vector<ComparedAxis const*> const& axes) {
  Names names;
  for (auto const* const axis : axes) names.push_back(axis->name);
  return names;
}

/// NC cycle time, axes of one side only, gantries.
Table machine_table(ShownDifference const& shown) {
  auto const& difference = shown.difference;
  auto table = side_table(shown, labels::what);
  add_difference(table, labels::cycle_time,
                 exact(difference.before.cycle_time.microseconds(), Unit::microsecond),
                 exact(difference.after.cycle_time.microseconds(), Unit::microsecond));
  for (auto const* const axis : difference.axes_removed) {
    add_difference(table, axis_title(shown, *axis, *axis), Words(says::present), {});
  }
  for (auto const* const axis : difference.axes_added) {
    add_difference(table, axis_title(shown, *axis, *axis), {}, Words(says::present));
  }
  std::map<std::string, std::pair<Names, Names>> slaves;
  for (auto const& gantry : difference.gantries_before) slaves[gantry.master].first = gantry.slaves;
  for (auto const& gantry : difference.gantries_after) slaves[gantry.master].second = gantry.slaves;
  for (auto const& [master, names] : slaves) {
    table.rows.push_back({Words(says::gantry, {{"master", master}}), names.first, names.second});
  }
  return table;
}

Names programs_of(ComparedChannel const& channel) {
  Names names;
  for (auto const& program : channel.programs) names.push_back(program.name);
  return names;
}

/// Those with other content say so.
Value marked_programs(ComparedChannel const& channel, Names const& other) {
  Value all;
  for (auto const& name : programs_of(channel)) {
    bool const is_other = std::find(other.begin(), other.end(), name) != other.end();
    auto const one = is_other ? Words(says::other_content, {{"program", name}}) : as_given(name);
    all = all.is_nothing() ? one : Words(says::more, {{"first", all}, {"next", one}});
  }
  return all;
}

Section channel_data(std::string key, ComparedChannel const& channel) {
  return data_section(
      std::move(key),
      {data("name", channel.name), data("axes", channel.axes), data("spindles", channel.spindles),
       data("couplings", channel.couplings), data("programs", programs_of(channel))});
}

/// Calls take(was, is) for what differs in how the channel drives its path, where both sides tell it.
template <class Take>
void for_each_change(ChannelDifference const& channel, Take take) {
  if (channel.before == nullptr || channel.after == nullptr) return;
  auto const& was = channel.before->dynamics;
  auto const& is = channel.after->dynamics;
  for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
    if (was[i] != is[i]) take(was[i], is[i]);
  }
}

Table dynamics_data(ChannelDifference const& channel) {
  Table table{.key = "dynamics",
              .columns = data_columns({"parameter", "name", "before", "after"}),
              .rows = {},
              .audience = Audience::programs};
  for_each_change(channel, [&table](ChannelValue const& was, ChannelValue const& is) {
    table.rows.push_back({std::string(is.number), std::string(is.name), was.value, is.value});
  });
  return table;
}

Section channel_section(ShownDifference const& shown, ChannelDifference const& channel) {
  ComparedChannel const none;
  auto const& was = channel.before != nullptr ? *channel.before : none;
  auto const& is = channel.after != nullptr ? *channel.after : none;
  bool const is_renamed = !was.name.empty() && !is.name.empty() && was.name != is.name;
  auto const name = is_renamed ? Words(says::compared, {{"before", was.name}, {"after", is.name}})
                               : as_given(is.name.empty() ? was.name : is.name);
  auto const other = programs_with_other_content(channel);
  auto table = side_table(shown, labels::what);
  add_difference(table, labels::axes, was.axes, is.axes);
  if (shown.difference.before.tells_all && shown.difference.after.tells_all) {
    add_difference(table, says::spindles, was.spindles, is.spindles);
    add_difference(table, says::couplings, was.couplings, is.couplings);
    add_difference(table, says::programs, marked_programs(was, {}), marked_programs(is, other));
    for_each_change(channel, [&table](ChannelValue const& old_value, ChannelValue const& new_value) {
      add_difference(table, as_given(std::string(new_value.name)), old_value.value, new_value.value);
    });
  }
  Section section{
      .key = {}, .title = Words(labels::one_channel, {{"name", name}}), .blocks = {std::move(table)}};
  for (auto const& [key, side] : {std::pair("before", channel.before), {"after", channel.after}}) {
    section.blocks.push_back(side != nullptr ? Block(channel_data(key, *side)) : Facts{{data(key, {})}});
  }
  section.blocks.emplace_back(Facts{{data("programs_with_other_content", other)}});
  section.blocks.emplace_back(dynamics_data(channel));
  return section;
}

Table gantry_data(std::string key, std::vector<ComparedGantry> const& gantries) {
  return table_of(std::move(key), data_columns({"master", "slaves"}), gantries, [](auto const& gantry) {
    return Row{gantry.master, gantry.slaves};
  });
}

/// "kenngr.antr_typ (U)".
Names restarting(MachineDifference const& difference) {
  std::map<std::string, std::string> axes_of;
  for (auto const& axis : difference.axes) {
    for (auto const& change : axis.parameters) {
      if (!change.restart || change.equal) continue;
      auto& axes = axes_of[change.name];
      axes.append(axes.empty() ? "" : ", ").append(axis.after->name);
    }
  }
  Names names;
  for (auto const& [name, axes] : axes_of) {
    names.push_back(std::string(name).append(" (").append(axes).append(")"));
  }
  return names;
}

/// Each change once, those that need a restart first.
Table all_changes(ShownDifference const& shown) {
  struct Change {
    Row row;
    bool restart = false;
    Names axes = {};
  };
  std::vector<Change> changes;
  auto const is_same = [](Value const& one, Value const& other) {
    return text_of(one, Language::english) == text_of(other, Language::english);
  };
  for (auto const& axis : shown.difference.axes) {
    for (auto const& change : axis.parameters) {
      auto row = parameter_row(shown, change);
      auto const known = std::find_if(changes.begin(), changes.end(), [&](Change const& other) {
        return std::equal(row.begin(), row.end(), other.row.begin(), is_same);
      });
      auto& one =
          known != changes.end() ? *known : changes.emplace_back(Change{std::move(row), change.restart});
      one.axes.push_back(axis.after->name);
    }
  }
  std::stable_partition(changes.begin(), changes.end(), [](Change const& one) { return one.restart; });
  auto table = parameter_table(shown);
  table.columns.insert(table.columns.begin(), head_column({}, labels::axes));
  for (auto& [row, restart, axes] : changes) {
    row.insert(row.begin(), axes);
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Why the sides may be one.
Paragraph doubt_of(ShownDifference const& shown) {
  return {Words(says::same_list, {{"list", shown.read_by_both.value_or("")}})};
}

/// What needs a restart, and what is not shown.
void add_remarks(std::vector<Block>& blocks, MachineDifference const& difference) {
  auto const add = [&](SentenceRef sentence, std::vector<NamedValue> values) {
    blocks.emplace_back(Paragraph{Words(sentence, std::move(values))});
  };
  if (!difference.before.image || !difference.after.image) add(says::no_effects, {});
  if (difference.needs_restart()) add(says::restart, {{"parameters", restarting(difference)}});
  if (!difference.left_out.empty()) add(says::own, {{"parameters", difference.left_out}});
  if (difference.set_to_default > 0) add(says::set_to_default, {{"count", difference.set_to_default}});
}

/// A cover has room for the first ones.
Names first_of(Names names) {
  constexpr std::size_t most = 5;
  if (names.size() <= most) return names;
  names.resize(most);
  names.emplace_back("…");
  return names;
}

}  // namespace

std::vector<Block> change_summary(ShownDifference const& shown) {
  auto const& difference = shown.difference;
  if (shown.read_by_both) return {doubt_of(shown)};
  if (difference.empty()) return {Paragraph{title_of(shown)}};
  auto changes = all_changes(shown);
  bool const has_changed_parameters = !changes.rows.empty();
  std::vector<Block> blocks{machine_table(shown), std::move(changes)};
  Names channels;
  for (auto const& channel : difference.channels) {
    channels.push_back((channel.after != nullptr ? channel.after : channel.before)->name);
  }
  if (!channels.empty()) {
    blocks.emplace_back(Paragraph{Words(says::other_channels, {{"channels", first_of(channels)}})});
  }
  if (difference.needs_restart()) {
    blocks.emplace_back(Paragraph{Words(says::restart, {{"parameters", first_of(restarting(difference))}})});
  } else if (has_changed_parameters) {
    blocks.emplace_back(Paragraph{says::no_restart});
  }
  return blocks;
}

std::pair<Words, Words> sides_of(ShownDifference const& shown) {
  if (shown.difference.of_one_machine) return {as_given(shown.before), as_given(shown.after)};
  return {labels::before, says::after};
}

Table side_table(ShownDifference const& shown, Words what) {
  auto const [before, after] = sides_of(shown);
  return {.key = {},
          .columns = {head_column({}, std::move(what)), column({}, before), column({}, after)},
          .rows = {},
          .audience = Audience::people};
}

void add_difference(Table& table, Words what, Value before, Value after) {
  if (text_of(before, Language::english) == text_of(after, Language::english)) return;
  table.rows.push_back({std::move(what), std::move(before), std::move(after)});
}

Document difference_answer(ShownDifference const& shown) {
  auto const& difference = shown.difference;
  Sections channels{.key = "channels", .items = {}};
  for (auto const& channel : difference.channels) channels.items.push_back(channel_section(shown, channel));
  Document answer{
      .title = title_of(shown),
      .blocks =
          {Facts{{data("before", shown.before), data("after", shown.after), data("equal", difference.empty()),
                  data("restart", difference.needs_restart()), data("feed_mm_per_min", shown.feed_mm_per_min),
                  data("cycle_time_us", difference.before.cycle_time.microseconds(), "before"),
                  data("cycle_time_us", difference.after.cycle_time.microseconds(), "after"),
                  data("axes_removed", names_of(difference.axes_removed)),
                  data("axes_added", names_of(difference.axes_added))}},
           machine_table(shown), std::move(channels),
           Section{.key = "gantries",
                   .title = {},
                   .blocks = {gantry_data("before", difference.gantries_before),
                              gantry_data("after", difference.gantries_after)}},
           Facts{{data("set_to_default", difference.set_to_default), data("left_out", difference.left_out)}},
           axes_data(shown)},
      .csv_table = "parameters"};
  for (auto& section : axis_sections(shown)) answer.blocks.emplace_back(std::move(section));
  if (shown.read_by_both) {
    answer.blocks.insert(answer.blocks.begin(), doubt_of(shown));
    answer.blocks.emplace_back(Facts{{data("read_by_both", *shown.read_by_both)}});
  }
  add_remarks(answer.blocks, difference);
  return answer;
}

}  // namespace axisc
