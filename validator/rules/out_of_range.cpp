#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/units_text.hpp"

namespace axisc::validator {
namespace {

/// The default list belongs to no axis: its axis number is 0 or missing, whatever the range of the others.
bool is_number_of_default_list(LoadedList const& list, schema::Parameter const& parameter, double value) {
  return list.is_default_list && parameter.name == "kopf.achs_nr" && value == 0;
}

void judge(AxisContext const& context, Report& report, Place place, schema::Slot slot, double value) {
  schema::Parameter const& parameter = context.values.row(slot);
  if (!is_outside(parameter, value) || is_default_or_off(parameter, value)) return;
  std::string_view const unit = unit_of(parameter, context.type);
  std::string const range = range_text(parameter, unit, true);
  Finding& finding =
      report.add(place, parameter, slot,
                 message_of(Text::ax2005, Argument{"parameter", schema::slot_name(parameter, slot)},
                            Argument{"range", range}));
  if (!unit.empty()) {
    finding.label = message_of(Text::parameter_value_in_unit, Argument{"value", physical(value, unit)});
  }
  if (is_scaled(unit)) {
    std::string const raw = range_text(parameter, unit, false);
    finding.notes.push_back(message_of(Text::ax2005_raw, Argument{"range", raw}));
  }
  std::string const file(context.values.catalogue().file_of(parameter));
  if (!file.empty()) finding.notes.push_back(message(Text::ax2005_file, {{"file", file}}));
}

bool is_number(schema::Parameter const& parameter) {
  return schema::is_integer(parameter.type) || parameter.type == schema::DataType::real64;
}

}  // namespace

void checks::out_of_range(AxisContext const& context, Report& report) {
  for (LoadedList const* const list : lists_of(context)) {
    if (list == nullptr) continue;
    for_each_doubtful(*list, [&](grammar::Assignment const& assignment, Reading const& reading) {
      if (!reading.known() || reading.status != ReadingStatus::value) return;
      schema::Parameter const& parameter = *reading.row;
      if (!is_number(parameter) || is_number_of_default_list(*list, parameter, reading.value.number)) return;
      judge(context, report, {.source = list->source, .span = assignment.value}, reading.slot,
            reading.value.number);
    });
  }
  for (schema::Slot const slot : context.values.referenced_slots()) {
    EffectiveValue const& value = context.values[slot];
    if (value.unusable || !is_number(*value.row)) continue;
    judge(context, report, *value.value_place(), slot, value.value.number);
  }
}

}  // namespace axisc::validator
