// What becomes of a finding between its rule and the one who reads it.
#include "validator/engine/report.hpp"

#include "support/catch.hpp"
#include "validator/engine/rule.hpp"

namespace {

using namespace axisc;
using namespace axisc::validator;

constexpr Place place{.source = SourceId{0}, .span = {.begin = 3, .end = 7}};

}  // namespace

TEST_CASE("the words of a finding are made when it is told, beside what its rule says of all") {
  ReportedFindings reported;
  int told = 0;
  Report report(reported, *find_rule(Code{2004}), "X");
  report.later(place, [&told](Finding& finding) {
    ++told;
    finding.message.text = finding.place == place ? Text::ax2004 : Text::ax2005;
  });
  CHECK(told == 0);

  Finding const finding = tell(reported, reported.findings.front());
  CHECK(told == 1);
  CHECK(finding.message.text == Text::ax2004);
  CHECK(finding.code == Code{2004});
  CHECK(finding.name == "out-of-data-range");
  CHECK(finding.axis == "X");
  CHECK(finding.control->message == "1001138");
}

TEST_CASE("a finding in words keeps them, and takes place, severity and axis of its record") {
  ReportedFindings reported;
  Report(reported, *find_rule(Code{3005}), "X").add(place, {.text = Text::ax3005, .arguments = {}});
  Reported& record = reported.findings.front();
  record.place.span.begin = 4;
  record.severity = Severity::warning;
  record.axis = {};
  record.cycle_time_assumed = true;

  Finding const finding = tell(reported, record);
  CHECK(finding.message.text == Text::ax3005);
  CHECK(finding.place->span.begin == 4);
  CHECK(finding.severity == Severity::warning);
  CHECK(finding.axis.empty());
  CHECK(finding.notes.back().text == Text::cycle_time_assumed_note);
}
