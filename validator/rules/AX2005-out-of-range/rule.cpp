#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/range_reactions.hpp"
#include "validator/views/units_text.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace axisc::validator::checks::ax2005::says {

constexpr Sentence parameter_value_in_unit{"this is {value}", "das sind {value}"};

constexpr Sentence headline{"`{parameter}` is out of range: {range}",
                            "`{parameter}` liegt außerhalb des Bereichs: {range}"};
constexpr Sentence in_cycles{"`{parameter}` is out of range: {range} cycles",
                             "`{parameter}` liegt außerhalb des Bereichs: {range} Zyklen"};
constexpr Sentence raw{"as written in the list: {range}", "in der Schreibweise der Liste: {range}"};
constexpr Sentence odd{"`{parameter}` must be even", "`{parameter}` muss gerade sein"};
constexpr Sentence even{"the nearest values allowed are `{below}` and `{above}`",
                        "die nächsten zulässigen Werte sind `{below}` und `{above}`"};
constexpr Sentence nearest{"the nearest value allowed is `{value}`",
                           "der nächste zulässige Wert ist `{value}`"};
constexpr Sentence file{"limit from {file}", "Grenze aus {file}"};

}  // namespace axisc::validator::checks::ax2005::says

namespace axisc::validator::checks::ax2005 {
namespace {

/// The default list belongs to no axis: its axis number is 0 or missing, whatever the range of the others.
bool is_number_of_default_list(LoadedList const& list, schema::Parameter const& parameter, double value) {
  return list.is_default_list && parameter.name == "kopf.achs_nr" && value == 0;
}

bool is_wrong(schema::Parameter const& parameter, double value) {
  return schema::is_number(parameter.type) && schema::is_outside(parameter, value) &&
         !is_default_or_off(parameter, value);
}

bool is_below(schema::Parameter const& parameter, double value) {
  schema::Limit const& minimum = parameter.minimum;
  return minimum.kind == schema::Limit::Kind::number && value <= minimum.number;
}

void say_reaction(Finding& finding, schema::Parameter const& parameter, double value) {
  say_range_reaction(finding, range_reactions, parameter,
                     is_below(parameter, value) ? Demand::minimum : Demand::maximum);
}

/// The value of the range that is nearest to one outside; none where a limit itself is not allowed, and reals
/// come as near to it as one likes.
std::optional<double> nearest_allowed(schema::Parameter const& parameter, double value) {
  bool const from_below = is_below(parameter, value);
  schema::Limit const& limit = from_below ? parameter.minimum : parameter.maximum;
  if (limit.kind != schema::Limit::Kind::number) return std::nullopt;
  if (!limit.open) return limit.number;
  if (!schema::is_integer(parameter.type)) return std::nullopt;
  return limit.number + (from_below ? 1 : -1);
}

void say_nearest(Finding& finding, schema::Parameter const& parameter, double value) {
  auto const nearest = nearest_allowed(parameter, value);
  if (nearest) finding.help.push_back(message_of(says::nearest, Argument{"value", exact_number(*nearest)}));
}

void describe(Finding& finding, AxisContext const& context, schema::Slot slot, double value) {
  schema::Parameter const& parameter = context.values.row(slot);
  name_parameter(finding, parameter, slot);
  std::string_view const unit = unit_of(parameter, context.type);
  say_reaction(finding, parameter, value);
  // As the list has it: T would look like a factor.
  bool const in_cycles = unit == "cycle";
  finding.message = message_of(
      in_cycles ? says::in_cycles : says::headline, Argument{"parameter", finding.parameter},
      Argument{"range", in_cycles ? range_text(parameter, {}, false) : range_text(parameter, unit, true)});
  if (!unit.empty() && !in_cycles) {
    finding.label = message_of(says::parameter_value_in_unit, Argument{"value", physical(value, unit)});
  }
  if (is_scaled(unit)) {
    finding.notes.push_back(message_of(says::raw, Argument{"range", range_text(parameter, unit, false)}));
  }
  std::string file(context.values.catalogue().file_of(parameter));
  if (!file.empty()) {
    finding.notes.push_back(message_of(says::file, Argument{"file", std::move(file)}));
  }
  say_nearest(finding, parameter, value);
}

/// In the numbers of the list: which kind of axis they are for is not known here.
void describe_line(Finding& finding, Line const& line) {
  LineValue const& line_value = line.line_value();
  Wording const range = range_text(*line_value.row, {}, false);
  finding.message =
      message_of(says::headline, Argument{"parameter", finding.parameter}, Argument{"range", range});
  say_reaction(finding, *line_value.row, line_value.value.number);
  say_nearest(finding, *line_value.row, line_value.value.number);
}

void out_of_range_in_list(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    LineValue const& line_value = line.line_value();
    bool const has_value = line_value.known() && line_value.status == ReadingStatus::value;
    if (!has_value || !is_wrong(*line_value.row, line_value.value.number)) return;
    report_line<describe_line>(report, line, line.assignment().value);
  });
}

/// Orders of the filters of conveyor tracking, of which only even ones are allowed.
constexpr std::array<std::string_view, 2> even_numbers{"conv_sync.order_pos_filter",
                                                       "conv_sync.order_v_filter"};

void odd_numbers(AxisContext const& context, Report& report) {
  for (std::string_view const name : even_numbers) {
    EffectiveValue const& value = context.values.at(name);
    double const number = value.value.number;
    if (value.unusable || !value.value_place() || std::fmod(number, 2) == 0) continue;
    if (is_wrong(*value.row, number)) continue;
    Finding& finding = report.add(value, message_of(says::odd, Argument{"parameter", parameter_name(value)}));
    say_range_reaction(finding, range_reactions, *value.row, Demand::even);
    finding.help.push_back(message_of(says::even, Argument{"below", exact_number(number - 1)},
                                      Argument{"above", exact_number(number + 1)}));
  }
}

void out_of_range(AxisContext const& context, Report& report) {
  odd_numbers(context, report);
  for_each_doubtful(context, [&](AxisLine const& line) {
    LineValue const& line_value = line.line_value();
    if (!line_value.known() || line_value.status != ReadingStatus::value) return;
    double const value = line_value.value.number;
    if (!is_wrong(*line_value.row, value) || is_number_of_default_list(line.list(), *line_value.row, value)) {
      return;
    }
    report.later(line.place(), [line](Finding& finding) {
      describe(finding, line.context, line.line_value().slot, line.line_value().value.number);
    });
  });
  for (schema::Slot const slot : context.values.referenced_slots()) {
    EffectiveValue const& value = context.values[slot];
    if (value.unusable || !is_wrong(*value.row, value.value.number)) continue;
    report.later(*value.value_place(), [&context, slot](Finding& finding) {
      describe(finding, context, slot, context.values[slot].value.number);
    });
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = messages_of<range_reactions>,
    .about =
        [](schema::Parameter const& parameter) {
          return schema::is_number(parameter.type) &&
                 (parameter.minimum.kind == schema::Limit::Kind::number ||
                  parameter.maximum.kind == schema::Limit::Kind::number);
        },
    .precedence = Precedence::after_family,
    .check = out_of_range,
    .list_check = out_of_range_in_list,
};

}  // namespace axisc::validator::checks::ax2005
