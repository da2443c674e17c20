// A pass that does not keep its tolerance. The planner lets none happen, so the pass is made up.
#include "axisc/answers/simulation/followed_program.hpp"
#include "axisc/answers/simulation/program_answer.hpp"
#include "presentation/writers.hpp"
#include "support/catch.hpp"

namespace not_kept_test {

using namespace axisc;
using Catch::Matchers::Contains;

namespace {

motion::PassSummary exceeding() {
  motion::PassSummary pass;
  pass.command = "#FILTER ON [AX_DEV=0.001]";
  pass.line = 7;
  pass.blocks = 1;
  pass.cycles = 1000;
  pass.tolerance = 0.001 * motion::units_per_mm;
  pass.axis_error[1] = 1.5 * *pass.tolerance;
  return pass;
}

std::string summary_of(motion::PassSummary const& pass, presentation::Format format) {
  SimulatedPath const path{.group = {}, .axes = {"X", "Y"}, .cycle_time = {1'000'000}};
  ProgramSummary summary(path);
  summary.pass(pass);
  return presentation::write(std::move(summary).answer({.blocks = 1, .cycles = 1000}), format, {});
}

}  // namespace

TEST_CASE("a pass beyond its tolerance is marked in every format, and said with both figures") {
  auto pass = exceeding();
  REQUIRE_FALSE(pass.keeps_tolerance());
  using presentation::Format;
  CHECK_THAT(summary_of(pass, Format::html), Contains("#FILTER ON [AX_DEV=0.001]: AX_DEV is not kept"));
  // A long cell is broken.
  CHECK_THAT(summary_of(pass, Format::text),
             Contains("#FILTER ON [AX_DEV=0.001]") && Contains("AX_DEV is not kept"));
  CHECK_THAT(summary_of(pass, Format::markdown), Contains(": AX_DEV is not kept"));
  CHECK_THAT(summary_of(pass, Format::json),
             Contains("\"tolerance_um\": 1,") && Contains("\"tolerance_kept\": false"));
  auto const said = not_kept(pass, "part.nc");
  CHECK_THAT(said.line(Language::english),
             Contains("part.nc:7") && Contains("axis error 1.5 µm, tolerance 1 µm"));
  CHECK_THAT(said.line(Language::german), Contains("Achsfehler 1,5 µm, Toleranz 1 µm"));
  pass.axis_error[1] = *pass.tolerance;
  CHECK(pass.keeps_tolerance());
  CHECK_THAT(summary_of(pass, Format::text), !Contains("not kept"));
  CHECK_THAT(summary_of(pass, Format::json), Contains("\"tolerance_kept\": true"));
}

}  // namespace not_kept_test
