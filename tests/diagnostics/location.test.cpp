#include "diagnostics/location.hpp"

#include "example_findings.hpp"
#include "support/catch.hpp"

using namespace axisc;
using namespace axisc::test;

TEST_CASE("a place has a file, a begin and the column behind its end") {
  DelayExample const example;
  Location const location = locate(*example.finding.place, example.sources);
  CHECK(location.file == "axes/x.lis");
  CHECK(location.begin.line == 12);
  CHECK(location.begin.column == 34);
  CHECK(location.end.line == 12);
  CHECK(location.end.column == 39);
}

TEST_CASE("the file of a finding is that of its place, else the one it names") {
  DelayExample example;
  CHECK(file_of(example.finding, example.sources) == "axes/x.lis");
  example.finding.place.reset();
  CHECK(file_of(example.finding, example.sources).empty());
  example.finding.file = "y.lis";
  CHECK(file_of(example.finding, example.sources) == "y.lis");
}

TEST_CASE("severities have one word for machines") {
  CHECK(severity_name(Severity::error) == "error");
  CHECK(severity_name(Severity::warning) == "warning");
  CHECK(severity_name(Severity::note) == "note");
}
