#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace axisc::validator::says {

constexpr Sentence parameter_value_in_unit{"this is {value}", "das sind {value}"};

constexpr Sentence headline{"`{parameter}` is out of range: {range}",
                            "`{parameter}` liegt außerhalb des Bereichs: {range}"};
constexpr Sentence raw{"as written in the list: {range}", "in der Schreibweise der Liste: {range}"};
constexpr Sentence reports{"it reports the value; what it continues with is not documented",
                           "sie meldet den Wert; womit sie weiterarbeitet, ist nicht dokumentiert"};
constexpr Sentence corrects{"it corrects the value", "sie korrigiert den Wert"};
constexpr Sentence switches_off{"it switches Improved Position Control of the axis off",
                                "sie schaltet die optimierte Lageregelung der Achse ab"};
constexpr Sentence nearest{"the nearest value allowed is `{value}`",
                           "der nächste zulässige Wert ist `{value}`"};
constexpr Sentence file{"limit from {file}", "Grenze aus {file}"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

/// The default list belongs to no axis: its axis number is 0 or missing, whatever the range of the others.
bool is_number_of_default_list(LoadedList const& list, schema::Parameter const& parameter, double value) {
  return list.is_default_list && parameter.name == "kopf.achs_nr" && value == 0;
}

bool is_wrong(schema::Parameter const& parameter, double value) {
  return schema::is_number(parameter.type) && schema::is_outside(parameter, value) &&
         !is_default_or_off(parameter, value);
}

struct Reaction {
  std::uint16_t p_axis;
  std::string_view message;  ///< number
  Sentence const& sentence;
};

constexpr std::array reactions{
    Reaction{80, "110490", says::reports},      Reaction{164, "110240", says::reports},
    Reaction{351, "110496", says::reports},     Reaction{568, "110627", says::corrects},
    Reaction{571, "110626", says::corrects},    Reaction{585, "110633", says::reports},
    Reaction{590, "110632", says::reports},     Reaction{593, "110637", says::reports},
    Reaction{750, "70593", says::reports},      Reaction{751, "70592", says::reports},
    Reaction{752, "70594", says::reports},      Reaction{754, "70603", says::switches_off},
    Reaction{755, "70604", says::switches_off}, Reaction{757, "70606", says::reports}};

void say_reaction(Finding& finding, schema::Parameter const& parameter) {
  auto const* const known = std::find_if(reactions.begin(), reactions.end(), [&](Reaction const& reaction) {
    return reaction.p_axis == parameter.p_axis;
  });
  if (known == reactions.end()) return;
  set_reaction(finding, known->sentence);
  finding.control->message = known->message;
}

/// The value of the range that is nearest to one outside; none where a limit itself is not allowed, and reals
/// come as near to it as one likes.
std::optional<double> nearest_allowed(schema::Parameter const& parameter, double value) {
  schema::Limit const& minimum = parameter.minimum;
  bool const is_below = minimum.kind == schema::Limit::Kind::number && value <= minimum.number;
  schema::Limit const& limit = is_below ? minimum : parameter.maximum;
  if (limit.kind != schema::Limit::Kind::number) return std::nullopt;
  if (!limit.open) return limit.number;
  if (!schema::is_integer(parameter.type)) return std::nullopt;
  return limit.number + (is_below ? 1 : -1);
}

void say_nearest(Finding& finding, schema::Parameter const& parameter, double value) {
  auto const nearest = nearest_allowed(parameter, value);
  if (nearest) finding.help.push_back(message_of(says::nearest, Argument{"value", exact_number(*nearest)}));
}

void describe(Finding& finding, AxisContext const& context, schema::Slot slot, double value) {
  schema::Parameter const& parameter = context.values.row(slot);
  name_parameter(finding, parameter, slot);
  std::string_view const unit = unit_of(parameter, context.type);
  finding.message = message_of(says::headline, Argument{"parameter", finding.parameter},
                               Argument{"range", range_text(parameter, unit, true)});
  say_reaction(finding, parameter);
  if (!unit.empty()) {
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

void out_of_range(AxisContext const& context, Report& report) {
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

extern constinit Rule const ax2005{
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

}  // namespace axisc::validator::checks
