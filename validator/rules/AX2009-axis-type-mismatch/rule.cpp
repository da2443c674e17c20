#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax2009::says {

constexpr Sentence translatory{"`{parameter}` is not meant for translatory axes",
                               "`{parameter}` ist für translatorische Achsen nicht vorgesehen"};
constexpr Sentence rotary{"`{parameter}` is not meant for rotary axes",
                          "`{parameter}` ist für rotatorische Achsen nicht vorgesehen"};
constexpr Sentence spindle{"`{parameter}` is not meant for spindles",
                           "`{parameter}` ist für Spindeln nicht vorgesehen"};
constexpr Sentence types{"axis types: {types}", "Achstypen: {types}"};
constexpr Sentence help{"remove the line, or correct the axis type (`kenngr.achs_typ`)",
                        "die Zeile entfernen, oder den Achstyp (`kenngr.achs_typ`) berichtigen"};

}  // namespace axisc::validator::checks::ax2009::says

namespace axisc::validator::checks::ax2009 {
namespace {

char letter(machine::AxisType type) {
  if (type == machine::AxisType::translatory) return 'T';
  return type == machine::AxisType::rotary ? 'R' : 'S';
}

SentenceRef headline(machine::AxisType type) {
  if (type == machine::AxisType::translatory) return says::translatory;
  return type == machine::AxisType::rotary ? says::rotary : says::spindle;
}

using Rows = std::vector<schema::Parameter const*>;

Rows rows_for_some_types(schema::Catalogue const& catalogue) {
  Rows rows;
  for (schema::Parameter const& row : catalogue.parameters()) {
    if (!row.axis_types.empty()) rows.push_back(&row);
  }
  return rows;
}

void describe(Finding& finding, AxisContext const& context, EffectiveValue const& value) {
  schema::Parameter const& row = *value.row;
  name_parameter(finding, row, value.slot);
  finding.message = message(headline(context.type), {{"parameter", finding.parameter}});
  std::string listed;
  for (char const type : row.axis_types) listed.append(listed.empty() ? "" : ", ").append(1, type);
  finding.notes.push_back(message(says::types, {{"types", listed}}));
  finding.help.push_back(message(says::help));
}

void check_row(AxisContext const& context, schema::Parameter const& row, Report& report) {
  if (row.axis_types.find(letter(context.type)) != std::string_view::npos) return;
  for (std::uint16_t i = 0; i < row.slots; ++i) {
    auto const slot = static_cast<schema::Slot>(static_cast<unsigned>(row.first_slot) + i);
    if (!context.values.is_set(slot)) continue;
    EffectiveValue const& value = context.values[slot];
    // A default list applies to axes of every type.
    if (value.origin != Origin::axis_list || !value.value_place()) continue;
    report.later(*value.value_place(),
                 [&context, &value](Finding& finding) { describe(finding, context, value); });
  }
}

void axis_type_mismatch(AxisContext const& context, Report& report) {
  schema::Catalogue const& catalogue = context.values.catalogue();
  static Rows const built_in = rows_for_some_types({});
  Rows const own = catalogue.is_built_in() ? Rows{} : rows_for_some_types(catalogue);
  for (schema::Parameter const* const row : catalogue.is_built_in() ? built_in : own) {
    check_row(context, *row, report);
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .about = [](schema::Parameter const& parameter) { return !parameter.axis_types.empty(); },
    .precedence = Precedence::after_text,
    .check = axis_type_mismatch,
};

}  // namespace axisc::validator::checks::ax2009
