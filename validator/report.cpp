#include "validator/rule.hpp"

#include <utility>

namespace axisc::validator {

Finding& Report::add(Place place, Message message) {
  Finding& finding = findings_.emplace_back();
  finding.code = rule->code;
  finding.name = rule->name;
  finding.severity = rule->severity;
  finding.place = place;
  finding.message = std::move(message);
  finding.axis = axis;
  if (!rule->control.empty()) finding.control.emplace().message = rule->control;
  return finding;
}

Finding& Report::add(Place place, schema::Parameter const& row, schema::Slot slot, Message message) {
  Finding& finding = add(place, std::move(message));
  finding.parameter = schema::slot_name(row, slot);
  finding.p_axis = schema::p_axis_text(row.p_axis);
  return finding;
}

Finding& Report::add(EffectiveValue const& at, Message message) {
  Place const place = at.value_place() ? *at.value_place() : at.name_place().value_or(Place{});
  return add(place, *at.row, at.slot, std::move(message));
}

}  // namespace axisc::validator
