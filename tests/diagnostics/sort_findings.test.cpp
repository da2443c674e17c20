#include "diagnostics/writers.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

using namespace axisc;

namespace {

Finding at(std::uint32_t source, std::uint32_t offset, std::uint16_t code, std::string axis = {}) {
  Finding finding;
  finding.code = Code{code};
  finding.place = Place{.source = SourceId{source}, .span = {.begin = offset, .end = offset + 1}};
  finding.axis = std::move(axis);
  return finding;
}

Finding without_place(std::string file, std::uint16_t code) {
  Finding finding;
  finding.code = Code{code};
  finding.file = std::move(file);
  return finding;
}

std::string order_of(std::vector<Finding> findings) {
  sort_findings(findings);
  std::string order;
  for (Finding const& finding : findings) {
    std::string const where = finding.place ? std::to_string(static_cast<unsigned>(finding.place->source)) +
                                                  ":" + std::to_string(finding.place->span.begin)
                                            : finding.file;
    order += where + " " + code_text(finding.code) + finding.axis + "\n";
  }
  return order;
}

}  // namespace

TEST_CASE("findings stand in the order of the sources, then of the text, then of the codes") {
  CHECK(order_of({at(1, 0, 1001), at(0, 9, 1001), at(0, 5, 3005), at(0, 5, 2005), at(0, 50, 1001)}) ==
        "0:5 AX2005\n0:5 AX3005\n0:9 AX1001\n0:50 AX1001\n1:0 AX1001\n");
}

TEST_CASE("findings without place stand first") {
  CHECK(order_of({at(0, 0, 1001), without_place("b", 9001), without_place("a", 9003),
                  without_place("a", 9001)}) == "a AX9001\na AX9003\nb AX9001\n0:0 AX1001\n");
}

TEST_CASE("equal findings keep their order") {
  CHECK(order_of({at(0, 0, 3005, "Z"), at(0, 0, 3005, "A"), at(0, 0, 3005, "M")}) ==
        "0:0 AX3005Z\n0:0 AX3005A\n0:0 AX3005M\n");
}
