#include "cli/compiled_machine.hpp"
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

namespace response_test {

using namespace axisc::test;

TEST_CASE("a frequency response as CSV and JSON", "[digits]") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const csv = run_axisc({"response", "m.axim", "--frequencies", "0,40,500"}, there);
  CHECK(csv.status == 0);
  check_golden("tests/cli/data/golden/response.csv", csv.out);
  auto const json = run_axisc(
      {"response", "m.axim", "--frequencies", "0, 40", "--port", "interface", "--format", "json"}, there);
  check_golden("tests/cli/data/golden/response.json", json.out);
}

TEST_CASE("200 points up to 0.5/T for one axis", "[digits]") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const outcome = run_axisc({"response", "m.axim", "--axis", "Y"}, there);
  CHECK(lines_of(outcome.out) == 201);
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains("\nY,0.05,") && Catch::Matchers::Contains("\nY,500,1,0,0,0,0\n"));
}

TEST_CASE("the frequencies of the filters are points of the grid") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "filter[0].enable 1\nfilter[0].order 1\nfilter[0].type BANDSTOP\nfilter[0].fg_f0 17.5\n");
  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms"}, there).status == 0);
  CHECK_THAT(run_axisc({"response", "x.axim"}, there).out, Catch::Matchers::Contains("\nx,17.5,"));
}

TEST_CASE("a frequency response for readers has decibels, degrees and milliseconds") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "filter[0].enable 1\nfilter[0].order 1\nfilter[0].type PT1\nfilter[0].time_constant 3183\n");
  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms"}, there).status == 0);
  auto const outcome = run_axisc({"response", "x.axim", "--frequencies", "0,50", "--format", "text"}, there);
  CHECK(outcome.status == 0);
  // A lag of the first order: half the power and 45 degrees at 1/(2 pi T).
  CHECK_THAT(outcome.out, Catch::Matchers::Contains(
                              "  axis  frequency [Hz]  gain [dB]  phase [\xC2\xB0]  group delay [ms]\n"
                              "  x                  0          0          0             3.157\n"
                              "  x                 50      -3.01        -45             1.618\n"));
}

TEST_CASE("the answer names the port as the command line does") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const rack = std::string(AXISC_SOURCE_DIR) + "/samples/motion/rack";
  REQUIRE(run_axisc({"compile", rack, "-o", "rack.axim", "--quiet"}, there).status == 0);
  for (std::string const port : {"setpoint", "velocity"}) {
    auto const outcome = run_axisc({"response", "rack.axim", "--port", port, "--format", "json"}, there);
    CHECK_THAT(outcome.out, Catch::Matchers::Contains("\"port\": \"" + port + "\""));
  }
}

TEST_CASE("what response refuses") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  for (std::string const frequencies : {"", ",", "-1", "500.1", "1;2", "nan"}) {
    auto const outcome = run_axisc({"response", "m.axim", "--frequencies", frequencies}, there);
    INFO(frequencies);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("is not a frequency from 0 to 500 Hz"));
  }
  CHECK_THAT(run_axisc({"response", "m.axim", "--axis", "Y", "--port", "interface"}, there).err,
             Catch::Matchers::Contains("has a filter on its additional interface"));
  CHECK_THAT(run_axisc({"response", "m.axim", "--at", "0:#FILTER OFF"}, there).err,
             Catch::Matchers::Contains("that \"#FILTER OFF\" could switch"));
  CHECK_THAT(run_axisc({"response", "m.axim", "--axis", "Q"}, there).err,
             Catch::Matchers::Contains("there is no axis \"Q\"; the axes are X, Y"));
  CHECK_THAT(run_axisc({"response", "m.axim", "--axis", "y"}, there).err,
             Catch::Matchers::Contains("there is no axis \"y\"; did you mean Y? The axes are X, Y"));
}

}  // namespace response_test
