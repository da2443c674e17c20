// The order of findings, on findings made up for it. Which of them stand is tested through the engine.
#include "validator/precedence.hpp"

#include "support/catch.hpp"
#include "validator/rule.hpp"

#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>

namespace {

using namespace axisc;
using namespace axisc::validator;

class Findings {
 public:
  Findings& add(std::uint32_t source, std::uint32_t offset, std::uint16_t code, std::string_view axis = {}) {
    Report report(reported_, *find_rule(Code{code}), axis);
    report.later({.source = SourceId{source}, .span = {.begin = offset, .end = offset + 1}}, nullptr);
    return *this;
  }

  [[nodiscard]] std::string in_output_order() const {
    Standing standing(reported_.findings.size());
    std::iota(standing.begin(), standing.end(), 0U);
    put_in_output_order(reported_, standing);
    std::string order;
    for (std::uint32_t const number : standing) {
      Reported const& finding = reported_.findings[number];
      order += std::to_string(static_cast<unsigned>(finding.place.source)) + ":" +
               std::to_string(finding.place.span.begin) + " " + code_text(finding.rule->code) +
               std::string(finding.axis) + "\n";
    }
    return order;
  }

 private:
  ReportedFindings reported_;
};

}  // namespace

TEST_CASE("findings stand in the order of the sources, then of the text, then of the codes") {
  Findings findings;
  findings.add(1, 0, 1001).add(0, 9, 1001).add(0, 5, 3005).add(0, 5, 2005).add(0, 50, 1001);
  CHECK(findings.in_output_order() == "0:5 AX2005\n0:5 AX3005\n0:9 AX1001\n0:50 AX1001\n1:0 AX1001\n");
}

TEST_CASE("equal findings keep their order") {
  Findings findings;
  findings.add(0, 0, 3005, "Z").add(0, 0, 3005, "A").add(0, 0, 3005, "M");
  CHECK(findings.in_output_order() == "0:0 AX3005Z\n0:0 AX3005A\n0:0 AX3005M\n");
}
