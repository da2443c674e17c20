#include "validator/engine/report.hpp"

#include "validator/engine/rule.hpp"
#include "validator/sentences.hpp"

#include <memory>
#include <string>
#include <utility>

namespace axisc::validator {

Finding new_finding(Rule const& rule) {
  Finding finding;
  finding.code = rule.code;
  finding.name = rule.name;
  finding.severity = rule.severity;
  if (!rule.control.empty()) finding.control.emplace().message = rule.control;
  return finding;
}

void adopt(ReportedFindings& reported, Rule const& rule, Finding const& found) {
  Finding& finding = Report(reported, rule).add(found.place.value_or(Place{}), found.message);
  Finding const known = finding;
  finding = found;
  finding.name = known.name;
  finding.severity = known.severity;
  finding.control = known.control;
}

Finding tell(ReportedFindings& reported, Reported const& finding) {
  // A copy: it may be a view of the finding that is moved.
  std::string axis(finding.axis);
  Finding told = finding.said ? std::move(*reported.said[*finding.said]) : new_finding(*finding.rule);
  told.place = finding.place;
  told.severity = finding.severity;
  told.axis = std::move(axis);
  if (finding.words) finding.words(told);
  if (finding.cycle_time_assumed) {
    told.notes.push_back({says::cycle_time_assumed_note});
  }
  return told;
}

Reported& Report::later(Place place, Words words) {
  Reported& reported = reported_.findings.emplace_back();
  reported.rule = &rule_;
  reported.place = place;
  reported.severity = rule_.severity;
  reported.axis = axis;
  reported.words = std::move(words);
  return reported;
}

Finding& Report::add(Place place, Message message) {
  later(place, nullptr).said = reported_.said.size();
  Finding& finding = *reported_.said.emplace_back(std::make_unique<Finding>(new_finding(rule_)));
  finding.place = place;
  finding.message = std::move(message);
  finding.axis = axis;
  return finding;
}

Finding& Report::add(Place place, schema::Parameter const& row, schema::Slot slot, Message message) {
  Finding& finding = add(place, std::move(message));
  finding.parameter = schema::slot_name(row, slot);
  finding.p_axis = schema::number_text(row.kind, row.p_axis);
  return finding;
}

Finding& Report::add(EffectiveValue const& at, Message message) {
  Place const place = at.value_place() ? *at.value_place() : at.name_place().value_or(Place{});
  return add(place, *at.row, at.slot, std::move(message));
}

}  // namespace axisc::validator
