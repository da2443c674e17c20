// What becomes of a finding between its rule and the one who reads it.
#include "validator/engine/report.hpp"

#include "support/catch.hpp"
#include "validator/engine/rule.hpp"
#include "validator/sentences.hpp"

namespace report_test {

namespace {

using namespace axisc;
using namespace axisc::validator;

constexpr Sentence out_of_data_range{"{value} does not fit {type}", "{value} passt nicht in {type}"};
constexpr Sentence out_of_range{"`{parameter}` is out of range: {range}",
                                "`{parameter}` liegt außerhalb des Bereichs: {range}"};
constexpr Sentence delay_too_long{"the delay must be shorter than 6 NC cycles",
                                  "die Verzögerung muss kürzer als 6 NC-Zyklen sein"};

constexpr Place place{.source = SourceId{0}, .span = {.begin = 3, .end = 7}};

}  // namespace

TEST_CASE("the words of a finding are made when it is told, beside what its rule says of all") {
  ReportedFindings reported;
  int told = 0;
  Report report(reported, *find_rule(Code{2004}), "X");
  report.later(place, [&told](Finding& finding) {
    ++told;
    finding.message.sentence = finding.place == place ? out_of_data_range : out_of_range;
  });
  CHECK(told == 0);

  Finding const finding = tell(reported, reported.findings.front());
  CHECK(told == 1);
  CHECK(finding.message.sentence == out_of_data_range);
  CHECK(finding.code == Code{2004});
  CHECK(finding.name == "out-of-data-range");
  CHECK(finding.axis == "X");
  CHECK(finding.control->message == "1001138");
}

TEST_CASE("a finding in words keeps them, and takes place, severity and axis of its record") {
  ReportedFindings reported;
  Report(reported, *find_rule(Code{3005}), "X").add(place, {delay_too_long});
  Reported& record = reported.findings.front();
  record.place.span.begin = 4;
  record.severity = Severity::warning;
  record.axis = {};
  record.cycle_time_assumed = true;

  Finding const finding = tell(reported, record);
  CHECK(finding.message.sentence == delay_too_long);
  CHECK(finding.place->span.begin == 4);
  CHECK(finding.severity == Severity::warning);
  CHECK(finding.axis.empty());
  CHECK(finding.notes.back().sentence == validator::says::cycle_time_assumed_note);
}

}  // namespace report_test
