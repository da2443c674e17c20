// The order of findings, on findings made up for it. Which of them stand is tested through the engine.
#include "validator/engine/precedence.hpp"

#include "support/catch.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <string_view>
#include <tuple>

namespace {

using namespace axisc;
using namespace axisc::validator;

class Findings {
 public:
  Findings& add(std::uint32_t source, std::uint32_t offset, std::uint16_t code, std::string_view axis = {}) {
    return add({.source = SourceId{source}, .span = {.begin = offset, .end = offset + 1}}, code, axis);
  }
  Findings& add(Place place, std::uint16_t code, std::string_view axis = {}) {
    Report report(reported_, *find_rule(Code{code}), axis);
    report.later(place, nullptr);
    return *this;
  }

  [[nodiscard]] Standing in_order() const {
    Standing standing(reported_.findings.size());
    std::iota(standing.begin(), standing.end(), 0U);
    put_in_order(reported_, standing);
    return standing;
  }

  [[nodiscard]] Reported const& operator[](std::uint32_t number) const { return reported_.findings[number]; }

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

TEST_CASE("findings are put in order by their place, their code and their number") {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    Findings findings;
    // From one run that is in order to a shuffle: rules report in the order of the list, but not all of them.
    std::size_t const length = random() % 60;
    std::size_t const run = 1 + random() % 20;
    std::uint32_t offset = 0;
    for (std::size_t i = 0; i < length; ++i) {
      offset = i % run == 0 ? static_cast<std::uint32_t>(random() % 10)
                            : offset + static_cast<std::uint32_t>(random() % 3);
      Span const span{.begin = offset, .end = offset + static_cast<std::uint32_t>(random() % 3)};
      findings.add({.source = SourceId{static_cast<std::uint32_t>(random() % 2)}, .span = span},
                   random() % 2 == 0 ? 1001 : 2003);
    }
    Standing expected(length);
    std::iota(expected.begin(), expected.end(), 0U);
    std::stable_sort(expected.begin(), expected.end(), [&findings](std::uint32_t a, std::uint32_t b) {
      return std::tuple(findings[a].place, findings[a].rule->code) <
             std::tuple(findings[b].place, findings[b].rule->code);
    });
    REQUIRE(findings.in_order() == expected);
  }
}
