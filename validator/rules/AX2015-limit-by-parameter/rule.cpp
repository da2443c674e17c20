// AX2015: limits that another parameter of the axis, or of the list, gives.
#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/range_reactions.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace axisc::validator::checks::ax2015::says {

constexpr Sentence headline{"`{parameter}` must be {relation} `{limit}`",
                            "`{parameter}` muss {relation} `{limit}` sein"};
constexpr Sentence label{"{value}, but it must be {relation} {limit}",
                         "{value}, muss aber {relation} {limit} sein"};
constexpr Sentence related{"the limit is set here: {limit}", "hier wird die Grenze gesetzt: {limit}"};
constexpr Sentence limit_by_parameter_default{
    "no list sets `{limit}` ({p_axis}): its default {value} applies",
    "keine Liste setzt `{limit}` ({p_axis}): es gilt der Standardwert {value}"};
constexpr Sentence help{"correct `{parameter}`, or its limit `{limit}`",
                        "`{parameter}` oder die Grenze `{limit}` berichtigen"};

}  // namespace axisc::validator::checks::ax2015::says

namespace axisc::validator::checks::ax2015 {
namespace {

using schema::Limit;
using schema::Slot;

/// `getriebe` of `getriebe[].dynamik.vb_max`.
std::string_view structure(std::string_view pattern) {
  return pattern.substr(0, pattern.find_first_of("[."));
}

/// The limiting parameter: at the same index, else at index 0. Entries of another structure have the same
/// index only where a list sets it: jog speed 3 does not belong to gear 3 of a machine with one gear.
std::optional<Slot> limiting_slot(EffectiveValues const& values, Slot limited, std::uint16_t number) {
  schema::Parameter const& parameter = values.row(limited);
  std::uint32_t const index = parameter.index_count() == 0 ? 0 : schema::indices_of(parameter, limited)[0];
  std::optional<Slot> fallback;
  for (schema::ParameterId const id : values.catalogue().find_number(number)) {
    schema::Parameter const& limit = values.catalogue().parameter(id);
    if (index < std::max<std::uint32_t>(limit.array[0], 1)) {
      Slot const slot = schema::slot_of(limit, index);
      bool const related = limit.array[0] != 0 && structure(limit.name) == structure(parameter.name);
      if (related || values[slot].set()) return slot;
    }
    if (!fallback) fallback = schema::slot_of(limit);
  }
  return fallback;
}

enum class Side : std::uint8_t { minimum, maximum };

struct Violation {
  Slot limit{};
  Side side{};
  bool open = false;
};

std::optional<Violation> violation_at(EffectiveValues const& values, Slot slot, Side side) {
  schema::Parameter const& parameter = values.row(slot);
  EffectiveValue const& value = values[slot];
  Limit const& limit = side == Side::minimum ? parameter.minimum : parameter.maximum;
  if (limit.kind != Limit::Kind::parameter || is_default_or_off(parameter, value.value.number)) {
    return std::nullopt;
  }
  std::optional<Slot> const other = limiting_slot(values, slot, limit.p_axis);
  if (!other || values[*other].unusable) return std::nullopt;
  if (!values[*other].set() && !schema::default_value(values.row(*other))) return std::nullopt;
  double const bound = values[*other].value.number;
  bool const violated = side == Side::minimum
                            ? schema::violates_minimum(value.value.number, bound, limit.open)
                            : schema::violates_maximum(value.value.number, bound, limit.open);
  if (!violated) return std::nullopt;
  return Violation{.limit = *other, .side = side, .open = limit.open};
}

/// If two parameters limit each other, the finding is at the later one.
bool is_reported_at_limit(EffectiveValues const& values, Slot slot, Violation const& violation) {
  EffectiveValue const& value = values[slot];
  EffectiveValue const& limit = values[violation.limit];
  if (!limit.set() || std::tie(limit.origin, limit.line) < std::tie(value.origin, value.line)) return false;
  Side const opposite = violation.side == Side::minimum ? Side::maximum : Side::minimum;
  std::optional<Violation> const back = violation_at(values, violation.limit, opposite);
  return back && back->limit == slot;
}

std::string relation(Violation const& violation) {
  if (violation.side == Side::minimum) return violation.open ? ">" : "≥";
  return violation.open ? "<" : "≤";
}

void add(AxisContext const& context, Report& report, Slot slot, Violation const& violation) {
  EffectiveValue const& value = context.values[slot];
  EffectiveValue const& limit = context.values[violation.limit];
  std::string const limit_name = parameter_name(limit);
  Wording const limit_value = physical(limit.value.number, unit_of(*limit.row, context.type));
  Wording const own_value = physical(value.value.number, unit_of(*value.row, context.type));
  std::string const sign = relation(violation);
  Finding& finding = report.add(
      value, message(says::headline,
                     {{"parameter", parameter_name(value)}, {"relation", sign}, {"limit", limit_name}}));
  finding.label = message(says::label, {{"value", own_value}, {"relation", sign}, {"limit", limit_value}});
  finding.help.push_back(message(says::help, {{"parameter", parameter_name(value)}, {"limit", limit_name}}));
  say_range_reaction(finding, limit_reactions, *value.row,
                     violation.side == Side::minimum ? Demand::minimum : Demand::maximum);
  if (limit.value_place()) {
    finding.related.push_back(
        {.place = *limit.value_place(), .message = message(says::related, {{"limit", limit_value}})});
  } else {
    finding.notes.push_back(
        message(says::limit_by_parameter_default,
                {{"limit", limit_name}, {"p_axis", parameter_number(limit)}, {"value", limit_value}}));
  }
}

void check_slot(AxisContext const& context, Report& report, Slot slot) {
  EffectiveValue const& value = context.values[slot];
  if (value.unusable || !value.value_place()) return;
  for (Side const side : {Side::minimum, Side::maximum}) {
    std::optional<Violation> const violation = violation_at(context.values, slot, side);
    if (!violation || is_reported_at_limit(context.values, slot, *violation)) continue;
    return add(context, report, slot, *violation);
  }
}

void limit_by_parameter(AxisContext const& context, Report& report) {
  for (Slot const slot : context.values.catalogue().slots_limited_by_others()) {
    if (context.values.is_set(slot)) check_slot(context, report, slot);
  }
}

/// Both are in one list of another kind: nothing is known about lists that it is used with.
void limit_in_list(ListContext const& context, Report& report) {
  LineValues const& line_values = context.list.line_values;
  schema::Catalogue const& catalogue = context.list.catalogue;
  auto const value_of = [&](Slot slot) -> std::optional<std::uint32_t> {
    std::uint32_t const last = line_values.last_of(slot);
    if (last == 0 || line_values[last - 1].status != ReadingStatus::value) return std::nullopt;
    return last - 1;
  };
  for (std::uint32_t line = 0; line < line_values.size(); ++line) {
    auto const slot = line_values.slot(line);
    if (!slot || value_of(*slot) != line) continue;
    schema::Parameter const& parameter = catalogue.parameter_of(*slot);
    double const value = line_values[line].value.number;
    for (Side const side : {Side::minimum, Side::maximum}) {
      Limit const& limit = side == Side::minimum ? parameter.minimum : parameter.maximum;
      auto const rows = catalogue.find_number(limit.p_axis);
      if (limit.kind != Limit::Kind::parameter || rows.empty()) continue;
      schema::Parameter const& row = catalogue.parameter(rows.front());
      Slot const other = row.index_count() == parameter.index_count()
                             ? schema::slot_of(row, schema::indices_of(parameter, *slot))
                             : row.first_slot;
      auto const limiting = value_of(other);
      if (!limiting) continue;
      double const bound = line_values[*limiting].value.number;
      bool const violated = side == Side::minimum ? schema::violates_minimum(value, bound, limit.open)
                                                  : schema::violates_maximum(value, bound, limit.open);
      if (!violated) continue;
      std::string const sign = relation({.limit = other, .side = side, .open = limit.open});
      auto const text_of = [&](std::uint32_t number) {
        return context.source.utf8(context.list.tree.assignments[number].value);
      };
      Finding& finding =
          report.add(place_of(context, context.list.tree.assignments[line].value), parameter, *slot,
                     message(says::headline, {{"parameter", schema::slot_name(parameter, *slot)},
                                              {"relation", sign},
                                              {"limit", schema::slot_name(row, other)}}));
      finding.control.reset();
      finding.help.push_back(message(says::help, {{"parameter", schema::slot_name(parameter, *slot)},
                                                  {"limit", schema::slot_name(row, other)}}));
      finding.label =
          message(says::label, {{"value", text_of(line)}, {"relation", sign}, {"limit", text_of(*limiting)}});
      finding.related.push_back({.place = place_of(context, context.list.tree.assignments[*limiting].value),
                                 .message = message(says::related, {{"limit", text_of(*limiting)}})});
    }
  }
}

bool is_about(schema::Parameter const& parameter) {
  auto const is_limit_of = [&](schema::Parameter const& limited) {
    return std::max(limited.minimum.p_axis, limited.maximum.p_axis) == parameter.p_axis;
  };
  auto const rows = schema::parameters();
  bool const is_limit = parameter.p_axis != 0 && std::any_of(rows.begin(), rows.end(), is_limit_of);
  return is_limit || schema::is_limited_by_another(parameter);
}

}  // namespace

extern constinit Rule const rule{
    .control = messages_of<limit_reactions>,
    .about = is_about,
    .precedence = Precedence::before_family,
    .check = limit_by_parameter,
    .list_check = limit_in_list,
};

}  // namespace axisc::validator::checks::ax2015
