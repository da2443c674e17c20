// Which constructs of NC programs a simulation ignores, and which it refuses.
#include "constructs.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace construct_refusals_test {

using namespace axisc::test;

namespace {

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("constructs: comments, skipped blocks and words without meaning for the path") {
  auto const found = simulated_construct("ignored.nc");
  check_times(found, {{"N20", rest_to_rest(10)}, {"N40", rest_to_rest(10)}, {"N50", rest_to_rest(10)}});
  auto const warned = run_construct("ignored.nc", {}).err;
  CHECK(count(warned, "warning[AX9007]") == 3);
  for (std::string const word : {"such as `M03`", "`A90`", "`#TIMER`"}) {
    CHECK(count(warned, word) == 1);
  }
}

namespace {

/// Each word once, each in the next line from the second one on.
void check_refused(std::string const& program, std::vector<std::string> const& words) {
  auto const outcome = run_construct(program, {});
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  for (auto const& word : words) CHECK(count(outcome.err, "error[AX9008]: " + word) == 1);
  CHECK(count(outcome.err, "error[AX9008]") == words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    CHECK(count(outcome.err, program + ":" + std::to_string(i + 2) + ":") == 1);
  }
}

}  // namespace

TEST_CASE("constructs: what would change the path is refused by name") {
  // N190 P1=V.A.ABS.X is refused as something that cannot be computed.
  check_refused("refused.nc", {"`G41`", "`G42`", "`G54`", "`G55`", "`G56`", "`G57`", "`G58`", "`G59`",
                               "`G92`", "`G159`", "`#CS`", "`#ACS`", "`#TRAFO`", "`#HSC`", "`#SLOPE`", "`L`",
                               "`$GOTO`", "the simulation cannot compute", "`G01`"});
}

TEST_CASE("constructs: words of other controls and motions that are not planned are refused by name") {
  check_refused("foreign.nc", {"`G64`", "`G193`", "`G293`", "`G13`", "`G61`", "`G261`", "`#CONTOUR`",
                               "`G116`", "`#DYNAMIC`", "`F700`"});
}

}  // namespace construct_refusals_test
