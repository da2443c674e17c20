#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace axisc::validator::checks::ax4015::says {

constexpr Sentence zero{"an axis needs a number above 0", "eine Achse braucht eine Nummer über 0"};
constexpr Sentence missing{"this axis list gives the axis no number",
                           "diese Achsliste gibt der Achse keine Nummer"};
constexpr Sentence default_list{"the default list must have axis number 0 or none, not {number}",
                                "die Standardliste muss die Achsnummer 0 oder keine haben, nicht {number}"};
constexpr Sentence twice{"the axes {axes} have the same number {number}",
                         "die Achsen {axes} haben dieselbe Nummer {number}"};
constexpr Sentence also_here{"axis \"{axis}\" has it here", "Achse „{axis}“ hat sie hier"};
constexpr Sentence reaction_aborts{"it aborts start-up", "sie bricht den Hochlauf ab"};
constexpr Sentence reaction_zero{"it reports the number as wrong", "sie meldet die Nummer als falsch"};
constexpr Sentence reaction_twice{"it reports the number as used twice",
                                  "sie meldet die Nummer als doppelt vergeben"};
constexpr Sentence help_default{"remove the line, or write 0", "die Zeile entfernen, oder 0 schreiben"};
constexpr Sentence help_missing{"add `kopf.achs_nr` with a number that no other axis has",
                                "`kopf.achs_nr` mit einer Nummer ergänzen, die keine andere Achse hat"};
constexpr Sentence help_own{"give every axis a number of its own, above 0",
                            "jeder Achse eine eigene Nummer über 0 geben"};

}  // namespace axisc::validator::checks::ax4015::says

namespace axisc::validator::checks::ax4015 {
namespace {

// Message numbers of the control.
constexpr std::string_view number_zero = "110076";
constexpr std::string_view number_in_default_list = "110300";
constexpr std::string_view number_twice = "1001121";

/// An axis whose own list gives it a number.
struct Numbered {
  LoadedAxis const& axis;
  EffectiveValue const& value;
};

std::vector<Numbered> numbered_axes(LoadedMachine const& machine) {
  std::vector<Numbered> found;
  for (LoadedAxis const& axis : machine.axes) {
    EffectiveValue const& value = axis.merged.values.at("kopf.achs_nr");
    bool const own = value.origin == Origin::axis_list && !value.unusable && value.value_place();
    if (own) found.push_back({axis, value});
  }
  return found;
}

/// The default list applies to every axis without a value of its own, so its number is checked separately.
void check_default_list(LoadedMachine const& machine, Report& report) {
  LoadedList const* const list = machine.list_of_defaults();
  if (list == nullptr) return;
  schema::Slot const slot = schema::slot_of(row_at("kopf.achs_nr"));
  for (std::size_t i = list->line_values.size(); i-- > 0;) {
    if (list->line_values.slot(i) != slot) continue;
    LineValue const line_value = list->line_values[i];
    if (line_value.status != ReadingStatus::value) continue;
    if (line_value.value.number == 0) return;
    Place const place{.source = list->source, .span = list->tree.assignments[i].value};
    Finding& finding = report.add(place, *line_value.row, slot,
                                  {says::default_list, {{"number", number(line_value.value.number)}}});
    finding.help.push_back({says::help_default, {}});
    react(finding, number_in_default_list, {says::reaction_aborts, {}});
    return;
  }
}

void check_zero(std::vector<Numbered> const& axes, Report& report) {
  for (Numbered const& numbered : axes) {
    if (numbered.value.value.number != 0) continue;
    report.axis = numbered.axis.name;
    Finding& finding = report.add(numbered.value, {says::zero, {}});
    finding.help.push_back({says::help_own, {}});
    react(finding, number_zero, {says::reaction_zero, {}});
  }
}

/// Start-up lists and projects join axes and channels by number. An update in XML holds only what changes,
/// and a list that has lost its text is another rule's.
void check_missing(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.start_up) return;
  std::set<std::size_t> told;
  for (LoadedAxis const& axis : machine.axes) {
    SourceId const source = machine.lists[axis.list].list.source;
    SourceText const& text = context.sources[source];
    if (has_own_number(axis) || text.is_translation() || is_blank(text)) continue;
    if (!told.insert(axis.list).second) continue;
    report.axis = axis.name;
    Finding& finding = report.add(beginning_of(source, text), {says::missing, {}});
    finding.help.push_back({says::help_missing, {}});
    react(finding, number_zero, {says::reaction_zero, {}});
  }
}

/// One line gives all of them their number: a start-up list names their list twice, which is AX7011.
bool is_one_line(std::vector<Numbered> const& sharing) {
  return std::all_of(sharing.begin(), sharing.end(), [&](Numbered const& each) {
    return *each.value.value_place() == *sharing.front().value.value_place();
  });
}

void check_twice(std::vector<Numbered> const& axes, bool start_up, Report& report) {
  std::map<double, std::vector<Numbered>> by_number;
  for (Numbered const& numbered : axes) {
    if (numbered.value.value.number != 0) by_number[numbered.value.value.number].push_back(numbered);
  }
  for (auto const& [value, sharing] : by_number) {
    if (sharing.size() < 2 || (start_up && is_one_line(sharing))) continue;
    auto const last =
        std::max_element(sharing.begin(), sharing.end(), [](Numbered const& left, Numbered const& right) {
          return *left.value.value_place() < *right.value.value_place();
        });
    std::string names;
    for (Numbered const& numbered : sharing) {
      names.append(names.empty() ? "" : ", ").append(numbered.axis.name);
    }
    report.axis = last->axis.name;
    Finding& finding = report.add(last->value, {says::twice, {{"number", number(value)}, {"axes", names}}});
    for (Numbered const& numbered : sharing) {
      if (*numbered.value.value_place() == *last->value.value_place()) continue;
      finding.related.push_back(
          {*numbered.value.value_place(), {says::also_here, {{"axis", numbered.axis.name}}}});
    }
    finding.help.push_back({says::help_own, {}});
    react(finding, number_twice, {says::reaction_twice, {}});
  }
}

void axis_number(MachineContext const& context, Report& report) {
  check_default_list(context.machine, report);
  check_missing(context, report);
  std::vector<Numbered> const axes = numbered_axes(context.machine);
  check_zero(axes, report);
  check_twice(axes, context.machine.start_up.has_value(), report);
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<number_zero, number_in_default_list, number_twice>,
    .parameters = "kopf.achs_nr",
    .check = axis_number,
};

}  // namespace axisc::validator::checks::ax4015
