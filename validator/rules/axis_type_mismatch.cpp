#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {
namespace {

char letter(AxisType type) {
  if (type == AxisType::translatory) return 'T';
  return type == AxisType::rotary ? 'R' : 'S';
}

Text headline(AxisType type) {
  if (type == AxisType::translatory) return Text::ax2009_translatory;
  return type == AxisType::rotary ? Text::ax2009_rotary : Text::ax2009_spindle;
}

}  // namespace

void checks::axis_type_mismatch(AxisContext const& context, Report& report) {
  for (schema::Slot const slot : context.values.set_slots()) {
    EffectiveValue const& value = context.values[slot];
    std::string_view const types = context.values.row(slot).axis_types;
    if (types.empty() || types.find(letter(context.type)) != std::string_view::npos) continue;
    // A default list serves axes of every type.
    if (value.origin != Origin::axis_list || !value.value_place()) continue;
    Finding& finding =
        report.add(value, message(headline(context.type), {{"parameter", parameter_name(value)}}));
    std::string listed;
    for (char const type : types) listed.append(listed.empty() ? "" : ", ").append(1, type);
    finding.notes.push_back(message(Text::ax2009_types, {{"types", listed}}));
  }
}

}  // namespace axisc::validator
