#include "diagnostics/fingerprint.hpp"

#include "example_findings.hpp"
#include "support/catch.hpp"

#include <set>
#include <string>
#include <vector>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("a fingerprint survives moved lines and other words") {
  DelayExample example;
  std::string const before = fingerprint(example.finding, example.sources);
  Finding moved = example.finding;
  moved.place = place_of(example.sources, example.list, "dead");
  moved.message = say("other words");
  moved.severity = Severity::warning;
  CHECK(fingerprint(moved, example.sources) == before);
}

TEST_CASE("a fingerprint tells code, axis, parameter and occurrence apart") {
  DelayExample const example;
  std::set<std::string> all{fingerprint(example.finding, example.sources)};
  auto const differs = [&](auto change) {
    Finding finding = example.finding;
    change(finding);
    return all.insert(fingerprint(finding, example.sources)).second;
  };
  CHECK(differs([](Finding& finding) { finding.code = Code{3004}; }));
  CHECK(differs([](Finding& finding) { finding.axis = "Y"; }));
  CHECK(differs([](Finding& finding) { finding.parameter = "filter[1].time_constant"; }));
  CHECK(differs([](Finding& finding) { finding.occurrence = 2; }));
  CHECK(differs([](Finding& finding) {
    finding.axis = "Xf";
    finding.parameter = "ilter[0].time_constant";
  }));
}

TEST_CASE("fingerprints never change: baselines hold them") {
  Identity const delay{
      .file = "axes/x.lis", .axis = "X", .parameter = "filter[0].time_constant", .code = Code{3005}};
  CHECK(fingerprint(delay, 1) == "8039c33eeff27854:1");
  CHECK(fingerprint({.file = "x.lis", .axis = "", .parameter = "", .code = Code{1002}}, 12) ==
        "ccec348033c57807:12");
}

TEST_CASE("an identity names the file, in well-formed text") {
  DelayExample example;
  CHECK(identity_of(example.finding, example.sources).file == "axes/x.lis");
  example.finding.place.reset();
  example.finding.file = "lists/G\xFCte.lis";
  CHECK(identity_of(example.finding, example.sources).file == "lists/G\xEF\xBF\xBDte.lis");
}

TEST_CASE("findings of equal axes in different files are different") {
  DelayExample example;
  auto const here = fingerprint(example.finding, example.sources);
  example.finding.place.reset();
  example.finding.file = "other/x.lis";
  CHECK(fingerprint(example.finding, example.sources) != here);
}
