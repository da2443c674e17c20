#include "axisc/answers/axis_type.hpp"
#include "axisc/answers/difference/difference_parts.hpp"
#include "axisc/answers/labels.hpp"

#include <map>
#include <set>
#include <tuple>

namespace axisc::says {

constexpr Sentence one_axis_of{"axis {axis} ({details})", "Achse {axis} ({details})"};
constexpr Sentence several_axes{"axes {axes}", "Achsen {axes}"};
constexpr Sentence number{"number {number}", "Nummer {number}"};
constexpr Sentence number_and_list{"number {number}, {list}", "Nummer {number}, {list}"};
constexpr Sentence name_in_programs{"name in programs", "Name im Programm"};
constexpr Sentence set_in{"set in", "gesetzt in"};
constexpr Sentence both_places{"{before} → {after}", "{before} → {after}"};
constexpr Sentence one_place{"{side}: {place}", "{side}: {place}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

struct AxisPart {
  Words title;
  Names axes = {};
  Table facts = {}, parameters = {}, places = {}, effects = {};
};

/// A change that a line of the default list makes for several axes.
auto key_of(ParameterChange const& change) {
  return std::tie(change.name, change.before.place, change.after.place, change.before.text,
                  change.after.text);
}

class AxisParts {
 public:
  explicit AxisParts(ShownDifference const& shown) : shown_(shown) {}

  std::vector<Section> sections() && {
    add_shared();
    auto const first = parts_.size();
    // Axes without facts of their own differ alike where the tables are the same.
    std::map<std::vector<std::string>, std::size_t> alike;
    for (auto const& axis : shown_.difference.axes) {
      auto one = part_of(axis);
      if (one.facts.rows.empty() && one.parameters.rows.empty() && one.effects.rows.empty()) continue;
      auto const [same, is_new] =
          one.facts.rows.empty() ? alike.emplace(cells_of(one), parts_.size()) : std::pair(alike.end(), true);
      if (is_new) {
        parts_.push_back(std::move(one));
        continue;
      }
      auto& part = parts_[same->second];
      part.axes.push_back(one.axes.front());
      part.places.rows.insert(part.places.rows.end(), one.places.rows.begin(), one.places.rows.end());
    }
    std::vector<Section> sections;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      auto& [title, axes, facts, parameters, places, effects] = parts_[i];
      if (axes.size() > 1) title = Words(says::several_axes, {{"axes", axes}});
      if (axes.size() == 1 || i < first) places.columns.front().audience = Audience::programs;
      sections.push_back(part(std::move(title), {std::move(facts), std::move(parameters), std::move(places),
                                                 std::move(effects)}));
    }
    return sections;
  }

 private:
  AxisPart empty_part(Words title, Names axes) const {
    return {.title = std::move(title),
            .axes = std::move(axes),
            .facts = side_table(shown_, labels::what),
            .parameters = parameter_table(shown_),
            .places = {.key = {},
                       .columns = {head_column({}, labels::axis), head_column({}, labels::parameter),
                                   column({}, says::set_in)},
                       .rows = {},
                       .audience = Audience::people},
            .effects = side_table(shown_, labels::parameter)};
  }

  void add(AxisPart& part, ParameterChange const& change) const {
    part.parameters.rows.push_back(parameter_row(shown_, change));
    auto const& [before, after] = std::tie(change.before.place, change.after.place);
    if (before.empty() && after.empty()) return;
    auto const sides = sides_of(shown_);
    auto const& label = before.empty() ? sides.second : sides.first;
    part.places.rows.push_back(
        {part.axes.front(), change.name,
         before.empty() || after.empty()
             ? Words(says::one_place, {{"side", label}, {"place", before.empty() ? after : before}})
             : Words(says::both_places, {{"before", before}, {"after", after}})});
  }

  /// What lines of the default list change for several axes.
  void add_shared() {
    auto const& axes = shown_.difference.axes;
    using Key = decltype(key_of(std::declval<ParameterChange const&>()));
    std::map<Key, Names> names_of;
    for (auto const& axis : axes) {
      for (auto const& change : axis.parameters) names_of[key_of(change)].push_back(axis.after->name);
    }
    std::map<Names, std::size_t> part_of;
    std::set<Key> seen;
    for (auto const& axis : axes) {
      for (auto const& change : axis.parameters) {
        auto const& names = names_of.at(key_of(change));
        if (names.size() < 2) continue;
        told_.insert(&change);
        if (!seen.insert(key_of(change)).second) continue;
        auto const [known, is_new] = part_of.emplace(names, parts_.size());
        if (is_new) parts_.push_back(empty_part(says::several_axes, names));
        add(parts_[known->second], change);
      }
    }
  }

  AxisPart part_of(AxisDifference const& axis) const {
    auto const& [was, is] = std::tie(*axis.before, *axis.after);
    auto part = empty_part(axis_title(shown_, was, is), {is.name});
    if (axis.renamed) add_difference(part.facts, says::name_in_programs, was.name, is.name);
    if (axis.other_type) {
      add_difference(part.facts, labels::type, axis_type_symbol(was.type), axis_type_symbol(is.type));
    }
    if (axis.other_drive) add_difference(part.facts, labels::drive, was.drive, is.drive);
    for (auto const& change : axis.parameters) {
      if (!told_.contains(&change)) add(part, change);
    }
    part.effects = effects_table(shown_, axis);
    return part;
  }

  static std::vector<std::string> cells_of(AxisPart const& part) {
    std::vector<std::string> cells;
    for (auto const* const table : {&part.effects, &part.parameters}) {
      for (auto const& row : table->rows) {
        for (auto const& cell : row) cells.push_back(text_of(cell, Language::english));
      }
      cells.emplace_back();
    }
    return cells;
  }

  ShownDifference const& shown_;
  std::vector<AxisPart> parts_;
  std::set<ParameterChange const*> told_;  ///< of several axes at once
};

std::string of_both(std::string const& before, std::string const& after) {
  return before == after || before.empty() ? after : before + " → " + after;
}

std::string number_of(ComparedAxis const& axis) {
  return axis.number ? std::to_string(*axis.number) : std::string();
}

}  // namespace

Words axis_title(ShownDifference const& shown, ComparedAxis const& was, ComparedAxis const& is) {
  bool const is_machine = shown.difference.before.tells_channels || shown.difference.after.tells_channels;
  if (!is_machine) return {labels::one_axis, {{"axis", is.name}}};
  auto const name = of_both(was.name, is.name);
  auto const number = of_both(number_of(was), number_of(is));
  auto const list = of_both(was.list, is.list);
  if (number.empty() && list.empty()) return {labels::one_axis, {{"axis", name}}};
  Value details = list;
  if (!number.empty()) {
    details = list.empty() ? Words(says::number, {{"number", number}})
                           : Words(says::number_and_list, {{"number", number}, {"list", list}});
  }
  return {says::one_axis_of, {{"axis", name}, {"details", std::move(details)}}};
}

Sections axes_data(ShownDifference const& shown) {
  Sections axes{.key = "axes", .items = {}};
  for (auto const& axis : shown.difference.axes) {
    auto const& [was, is] = std::tie(*axis.before, *axis.after);
    auto& section = axes.items.emplace_back(
        Section{.key = {},
                .title = {},
                .blocks = {parameter_data(axis)},
                .identity = {data("name", is.name), data("name_before", was.name),
                             data("number_before", was.number), data("number_after", is.number),
                             data("list_before", was.list), data("list_after", is.list)}});
    if (axis.motion) section.blocks.emplace_back(motion_data(*axis.motion));
    if (!axis.chain) continue;
    for (auto& block : effects_data(shown, *axis.chain)) section.blocks.push_back(std::move(block));
  }
  return axes;
}

std::vector<Section> axis_sections(ShownDifference const& shown) {
  return AxisParts(shown).sections();
}

}  // namespace axisc
