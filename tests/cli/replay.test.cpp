// `axisc run --record` and `axisc replay`.
#include "cli/compiled_machine.hpp"
#include "support/catch.hpp"

using namespace axisc::test;
using Catch::Matchers::Contains;

TEST_CASE("a recording replays bit for bit, from its first cycle and from a later one") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  for (std::string const cycles : {"1000", "40"}) {
    for (std::string const level : {"portable", "auto"}) {
      auto const made = run_axisc({"run", "m.axim", "--signal", "ramp:2000", "--cycles", "300", "--level",
                                   level, "--record", "r.axrd", "--record-cycles", cycles, "-o", "run.csv"},
                                  there);
      REQUIRE(made.status == 0);
      auto const replayed = run_axisc({"replay", "m.axim", "r.axrd", "-o", "replay.csv"}, there);
      INFO(replayed.out << replayed.err);
      CHECK(replayed.status == 0);
      CHECK_THAT(replayed.out, Contains("bit for bit"));
      // The outputs are those that `run` wrote: its last line holds the axes' outputs, the replay's every second number.
      auto const run = folder.read("run.csv");
      auto const table = folder.read("replay.csv");
      std::string last = run.substr(run.rfind('\n', run.size() - 2) + 1);
      std::string const first_output = last.substr(0, last.find_first_of(",\n"));
      std::string const row = table.substr(table.rfind('\n', table.size() - 2) + 1);
      CHECK_THAT(row, Contains("," + first_output));
    }
  }
}

TEST_CASE("a replay says what happened in which cycle") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("in.csv", "X\n0\n0\nnan\nnan\n0\n1e9\n1e9\n1e9\n");
  REQUIRE(run_axisc({"run", "m.axim", "--input", "in.csv", "--record", "r.axrd", "--quiet"}, there).status ==
          0);
  auto const text = run_axisc({"replay", "m.axim", "r.axrd"}, there);
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("cycle 0") && Contains("reset to 0"));
  CHECK_THAT(text.out, Contains("cycle 2-3") && Contains("AXISRT_BAD_INPUT"));
  CHECK_THAT(text.out, Contains("AXISRT_IMPLAUSIBLE"));
  auto const json = run_axisc({"replay", "m.axim", "r.axrd", "--format", "json"}, there);
  CHECK_THAT(json.out, Contains("\"first_cycle\": 2") && Contains("\"differences\": 0"));
  auto const german = run_axisc({"replay", "m.axim", "r.axrd", "--lang", "de"}, there);
  CHECK_THAT(german.out, Contains("Bit für Bit") && Contains("zurückgesetzt auf 0"));
}

TEST_CASE("a jump of an output is a warning of `run`") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const run =
      run_axisc({"run", "m.axim", "--signal", "step", "--amplitude", "1e9", "--cycles", "5"}, there);
  CHECK(run.status == 0);
  CHECK_THAT(run.err, Contains("P-AXIS-00212") && Contains("cycle"));
  CHECK(run_axisc({"run", "m.axim", "--signal", "step", "--amplitude", "1e9", "--cycles", "5", "--quiet"},
                  there)
            .err.empty());
}

TEST_CASE("what is no recording of this image is refused in one line") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  REQUIRE(run_axisc({"run", "m.axim", "--signal", "step", "--cycles", "20", "--record", "r.axrd"}, there)
              .status == 0);
  auto const expect = [&](std::vector<std::string> const& arguments, std::string const& what) {
    auto const outcome = run_axisc(arguments, there);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(what));
  };
  expect({"replay", "m.axim", "m.axim"}, "AXISRT_BAD_RECORDING");
  expect({"replay", "m.axim", "nowhere.axrd"}, "nowhere.axrd");
  expect({"replay", "m.axim"}, "RECORDING");
  expect({"replay", "m.axim", "r.axrd", "-o", "r.axrd"}, "r.axrd");
  std::string bytes = folder.read("r.axrd");
  folder.write("cut.axrd", bytes.substr(0, bytes.size() - 8));
  expect({"replay", "m.axim", "cut.axrd"}, "cut.axrd");
  folder.write("empty.axrd", "");
  expect({"replay", "m.axim", "empty.axrd"}, "empty.axrd");
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";
  REQUIRE(
      run_axisc({"compile", machine, "-o", "newer.axim", "--image-version", "7", "--strip", "--quiet"}, there)
          .status == 0);
  expect({"replay", "newer.axim", "r.axrd"}, "AXISRT_OTHER_IMAGE");
  expect({"run", "m.axim", "--record-cycles", "7"}, "--record");
  expect({"run", "m.axim", "--record", "r.axrd", "--record-cycles", "0"}, "--record-cycles");
}
