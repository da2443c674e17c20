#include "axisc/answers/difference/diff_words.hpp"

#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace axisc::says {

constexpr Sentence nothing{"{before} and {after} mean the same", "{before} und {after} bedeuten dasselbe"};
constexpr Sentence axis{"axis {axis}", "Achse {axis}"};
constexpr Sentence axes{"axes {axes}", "Achsen {axes}"};
constexpr Sentence number{"number {number}", "Nummer {number}"};
constexpr Sentence present{"present", "vorhanden"};
constexpr Sentence name_in_programs{"name in programs", "Name im Programm"};
constexpr Sentence type{"type", "Typ"};
constexpr Sentence drive{"drive", "Antrieb"};
constexpr Sentence translatory{"translatory", "translatorisch"};
constexpr Sentence rotary{"rotary", "rotatorisch"};
constexpr Sentence spindle{"spindle", "Spindel"};
constexpr Sentence channel{"channel {name}", "Kanal {name}"};
constexpr Sentence nc_cycle_time{"NC cycle time", "NC-Zykluszeit"};
constexpr Sentence channel_axes{"axes", "Achsen"};
constexpr Sentence channel_spindles{"spindles", "Spindeln"};
constexpr Sentence channel_couplings{"coupled (slave = master)", "gekoppelt (Slave = Master)"};
constexpr Sentence channel_programs{"programs", "Programme"};
constexpr Sentence other_content{"{program} (other content)", "{program} (anderer Inhalt)"};
constexpr Sentence gantry{"gantry of {master}: slaves", "Gantry von {master}: Slaves"};
constexpr Sentence restart{"after a restart of the control: {parameters}",
                           "erst nach einem Neustart der Steuerung: {parameters}"};
constexpr Sentence of_axis{"{parameter} ({axes})", "{parameter} ({axes})"};
constexpr Sentence set_to_default{
    "left out, as they only write out a default: {count} (--all shows them)",
    "weggelassen, weil sie nur einen Standardwert ausschreiben: {count} (--all zeigt sie)"};
constexpr Sentence own{"left out, as each axis has its own: {parameters} (--all shows them)",
                       "weggelassen, weil jede Achse eigene hat: {parameters} (--all zeigt sie)"};
constexpr Sentence no_effects{"what this does to the axes is left out, because a list has errors",
                              "was das mit den Achsen macht, fehlt, weil eine Liste Fehler hat"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string joined(std::vector<std::string> const& words) {
  std::string text;
  for (auto const& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "-" : text;
}

std::string cycle_time(design::CycleTime time, Language language) {
  return exact_number(time.microseconds()).in(language) + " µs";
}

SentenceRef type_name(machine::AxisType type) {
  if (type == machine::AxisType::spindle) return says::spindle;
  return type == machine::AxisType::rotary ? says::rotary : says::translatory;
}

std::string or_none(std::string const& text) {
  return text.empty() ? "-" : text;
}

/// Before and after of one fact; nothing where they are equal.
void add_line(std::vector<DiffLine>& lines, std::string what, std::string before, std::string after) {
  if (before != after) lines.push_back({std::move(what), std::move(before), std::move(after)});
}

/// A change that a line of the default list makes for several axes.
auto key_of(ParameterChange const& change) {
  return std::tie(change.name, change.before.place, change.after.place, change.before.text,
                  change.after.text);
}
using SharedKey = decltype(key_of(std::declval<ParameterChange const&>()));

/// Axes that have the same change, from the same lines of the same files.
std::map<SharedKey, std::vector<AxisDifference const*>> axes_by_change(MachineDifference const& difference) {
  std::map<SharedKey, std::vector<AxisDifference const*>> axes;
  for (auto const& axis : difference.axes) {
    for (auto const& change : axis.parameters) axes[key_of(change)].push_back(&axis);
  }
  return axes;
}

/// Axes without facts of their own differ alike where these lines are the same.
using AlikeKey = std::vector<std::array<std::string, 3>>;
AlikeKey alike_key(DiffSection const& section) {
  AlikeKey key;
  for (auto const& effect : section.effects) key.push_back({effect.what, effect.before, effect.after});
  key.emplace_back();
  for (auto const& parameter : section.parameters) {
    key.push_back({parameter.line.what, parameter.line.before, parameter.line.after});
  }
  return key;
}

/// Places of several axes begin with the axis.
void add_axis(DiffSection& section, DiffSection const& other) {
  auto const named = [](std::vector<std::string> places, std::string const& axis) {
    places.front().insert(0, axis + ": ");
    return places;
  };
  for (std::size_t i = 0; i < section.parameters.size(); ++i) {
    auto& places = section.parameters[i].places;
    if (section.axes.size() == 1) places.front() = named(places.front(), section.axes.front());
    places.push_back(named(other.parameters[i].places.front(), other.axes.front()));
  }
  section.axes.push_back(other.axes.front());
}

}  // namespace

std::string DiffWords::say(SentenceRef text, std::vector<Argument> arguments) const {
  return render({.sentence = text, .arguments = std::move(arguments)}, language_);
}

std::string DiffWords::nothing(std::string const& before, std::string const& after) const {
  return say(says::nothing, {{"before", before}, {"after", after}});
}

std::vector<DiffLine> DiffWords::machine() const {
  auto const& difference = shown_.difference;
  std::vector<DiffLine> lines;
  add_line(lines, say(says::nc_cycle_time), cycle_time(difference.before.cycle_time, language_),
           cycle_time(difference.after.cycle_time, language_));
  for (auto const* const axis : difference.axes_removed) {
    lines.push_back({say(says::axis, {{"axis", axis_name(*axis, *axis)}}), say(says::present), "-"});
  }
  for (auto const* const axis : difference.axes_added) {
    lines.push_back({say(says::axis, {{"axis", axis_name(*axis, *axis)}}), "-", say(says::present)});
  }
  std::map<std::string, std::pair<std::string, std::string>> slaves;
  for (auto const& gantry : difference.gantries_before) slaves[gantry.master].first = joined(gantry.slaves);
  for (auto const& gantry : difference.gantries_after) slaves[gantry.master].second = joined(gantry.slaves);
  for (auto const& [master, names] : slaves) {
    lines.push_back({say(says::gantry, {{"master", master}}), or_none(names.first), or_none(names.second)});
  }
  return lines;
}

std::vector<DiffSection> DiffWords::channels() const {
  std::vector<DiffSection> sections;
  for (auto const& difference : shown_.difference.channels) sections.push_back(channel(difference));
  return sections;
}

DiffSection DiffWords::channel(ChannelDifference const& channel) const {
  ComparedChannel const none;
  ComparedChannel const& was = channel.before != nullptr ? *channel.before : none;
  ComparedChannel const& is = channel.after != nullptr ? *channel.after : none;
  auto name = was.name.empty() || was.name == is.name || is.name.empty()
                  ? (is.name.empty() ? was.name : is.name)
                  : was.name + " → " + is.name;
  DiffSection section{.title = say(says::channel, {{"name", std::move(name)}})};
  auto const add = [&](SentenceRef what, std::vector<std::string> const& a,
                       std::vector<std::string> const& b) {
    add_line(section.facts, say(what), joined(a), joined(b));
  };
  add(says::channel_axes, was.axes, is.axes);
  if (!shown_.difference.before.tells_all || !shown_.difference.after.tells_all) return section;
  add(says::channel_spindles, was.spindles, is.spindles);
  add(says::channel_couplings, was.couplings, is.couplings);
  std::vector<std::string> old_programs;
  std::vector<std::string> new_programs;
  for (auto const& program : was.programs) old_programs.push_back(program.name);
  auto const other = programs_with_other_content(channel);
  for (auto const& program : is.programs) {
    bool const is_other = std::find(other.begin(), other.end(), program.name) != other.end();
    new_programs.push_back(is_other ? say(says::other_content, {{"program", program.name}}) : program.name);
  }
  add(says::channel_programs, old_programs, new_programs);
  return section;
}

std::vector<DiffSection> DiffWords::axes() const {
  std::set<ParameterChange const*> told;
  std::vector<DiffSection> sections = shared(told);
  auto const first = sections.size();
  std::map<AlikeKey, std::size_t> alike;
  for (auto const& difference : shown_.difference.axes) {
    auto section = axis(difference, told);
    if (section.facts.empty() && section.parameters.empty() && section.effects.empty()) continue;
    auto const [same, is_new] = section.facts.empty() ? alike.emplace(alike_key(section), sections.size())
                                                      : std::pair(alike.end(), true);
    if (is_new) {
      sections.push_back(std::move(section));
    } else {
      add_axis(sections[same->second], section);
    }
  }
  for (std::size_t i = first; i < sections.size(); ++i) {
    if (sections[i].axes.size() > 1) {
      sections[i].title = say(says::axes, {{"axes", joined(sections[i].axes)}});
    }
  }
  return sections;
}

std::vector<DiffSection> DiffWords::shared(std::set<ParameterChange const*>& told) const {
  auto const axes_of = axes_by_change(shown_.difference);
  std::vector<DiffSection> sections;
  std::map<std::vector<AxisDifference const*>, std::size_t> section_of;
  for (auto const& axis : shown_.difference.axes) {
    for (auto const& change : axis.parameters) {
      auto const& sharing = axes_of.at(key_of(change));
      if (sharing.size() < 2) continue;
      told.insert(&change);
      if (sharing.front() != &axis) continue;
      auto const [known, is_new] = section_of.emplace(sharing, sections.size());
      if (is_new) {
        std::vector<std::string> names;
        for (auto const* const other : sharing) names.push_back(other->after->name);
        sections.push_back({.title = say(says::axes, {{"axes", joined(names)}})});
      }
      sections[known->second].parameters.push_back(parameter(change));
    }
  }
  return sections;
}

DiffSection DiffWords::axis(AxisDifference const& axis, std::set<ParameterChange const*> const& told) const {
  DiffSection section{.title = say(says::axis, {{"axis", axis_name(*axis.before, *axis.after)}}),
                      .axes = {axis.after->name}};
  if (axis.renamed) {
    section.facts.push_back({say(says::name_in_programs), axis.before->name, axis.after->name});
  }
  if (axis.other_type) {
    section.facts.push_back(
        {say(says::type), say(type_name(axis.before->type)), say(type_name(axis.after->type))});
  }
  if (axis.other_drive) {
    section.facts.push_back({say(says::drive), or_none(axis.before->drive), or_none(axis.after->drive)});
  }
  for (auto const& change : axis.parameters) {
    if (!told.contains(&change)) section.parameters.push_back(parameter(change));
  }
  if (axis.chain) section.effects = effects(*axis.chain);
  return section;
}

std::string DiffWords::axis_name(ComparedAxis const& was, ComparedAxis const& is) const {
  bool const is_machine = shown_.difference.before.tells_channels || shown_.difference.after.tells_channels;
  if (!is_machine) return is.name;
  auto const of_both = [](std::string const& before, std::string const& after) {
    return before == after || before.empty() ? after : before + " → " + after;
  };
  auto const number = [](ComparedAxis const& axis) {
    return axis.number ? std::to_string(*axis.number) : std::string();
  };
  std::string details;
  if (auto const numbers = of_both(number(was), number(is)); !numbers.empty()) {
    details = say(says::number, {{"number", numbers}});
  }
  if (auto const lists = of_both(was.list, is.list); !lists.empty()) {
    details += (details.empty() ? "" : ", ") + lists;
  }
  return of_both(was.name, is.name) + (details.empty() ? "" : " (" + details + ")");
}

std::vector<std::string> DiffWords::remarks() const {
  auto const& difference = shown_.difference;
  std::vector<std::string> remarks;
  if (!difference.before.image || !difference.after.image) remarks.push_back(say(says::no_effects));
  if (difference.needs_restart()) {
    std::map<std::string, std::vector<std::string>> axes_of;
    for (auto const& axis : difference.axes) {
      for (auto const& change : axis.parameters) {
        if (change.restart && !change.equal) axes_of[change.name].push_back(axis.after->name);
      }
    }
    std::vector<std::string> parameters;
    parameters.reserve(axes_of.size());
    for (auto const& [name, axes] : axes_of) {
      parameters.push_back(say(says::of_axis, {{"parameter", name}, {"axes", joined(axes)}}));
    }
    remarks.push_back(say(says::restart, {{"parameters", joined(parameters)}}));
  }
  if (!difference.left_out.empty()) {
    remarks.push_back(say(says::own, {{"parameters", joined(difference.left_out)}}));
  }
  if (difference.set_to_default > 0) {
    remarks.push_back(say(says::set_to_default, {{"count", std::to_string(difference.set_to_default)}}));
  }
  return remarks;
}

}  // namespace axisc
