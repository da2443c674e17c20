#include "report_example.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <string>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("workflow commands of GitHub") {
  ReportExample const example;
  check_golden("tests/diagnostics/data/github/findings.en.txt", example.report(FindingFormat::github));
}

TEST_CASE("what would end a workflow command is escaped") {
  SourceSet sources;
  SourceId const list = sources.add(SourceText("a,b:c%.lis", "x\n"));
  Finding const finding = error_at(place_of(sources, list, "x"), "50 %: a, b\r\nc");
  CHECK(whole_report(FindingFormat::github, {finding}, sources) ==
        "::error file=a%2Cb%3Ac%25.lis,line=1,endLine=1,col=1,endColumn=2,title=AX3005 delay-too-long::"
        "50 %25: a, b␍␊c\n");
}
