#include "diagnostics/finding.hpp"

#include "support/catch.hpp"

using namespace axisc;

TEST_CASE("a code is written with four digits") {
  CHECK(code_text(Code{3005}) == "AX3005");
  CHECK(code_text(Code{9001}) == "AX9001");
  CHECK(code_text(Code{7}) == "AX0007");
}

TEST_CASE("findings are counted by severity") {
  std::vector<Finding> findings(6);
  findings[1].severity = Severity::warning;
  findings[2].severity = Severity::note;
  findings[3].severity = Severity::warning;
  FindingCounts const counts = count(findings);
  CHECK(counts.errors == 3);
  CHECK(counts.warnings == 2);
  CHECK(counts.notes == 1);
  CHECK(count({}).errors == 0);
}
