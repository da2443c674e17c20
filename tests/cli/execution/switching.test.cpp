// FIR and HSC filters, the commands that switch them, and Improved Position Control, from the command line.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

namespace switching_test {

using namespace axisc::test;

namespace {

Surroundings compiled_with_switches(TemporaryFolder const& folder) {
  Surroundings const there = in_folder(folder.path());
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/switching/machine.json";
  auto const outcome = run_axisc({"compile", machine, "-o", "m.axim", "--quiet"}, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return there;
}

/// The last line of a table, or the one `back` lines before it.
std::string line_from_end(std::string const& text, std::size_t back = 0) {
  std::size_t end = text.size() - 1;
  for (; back > 0; --back) end = text.rfind('\n', end - 1);
  std::size_t const begin = text.rfind('\n', end - 1) + 1;
  return text.substr(begin, end - begin);
}

}  // namespace

TEST_CASE("kernels, channels and position control as text and JSON") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  for (std::string const language : {"en", "de"}) {
    check_golden("tests/cli/data/golden/inspect-switching." + language + ".text",
                 run_axisc({"inspect", "m.axim", "--lang", language}, there).out);
  }
  check_golden("tests/cli/data/golden/inspect-switching.json",
               run_axisc({"inspect", "m.axim", "--format", "json"}, there).out);
}

TEST_CASE("a command at cycle 0 belongs to the start") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  std::vector<std::string> const ramp{"run", "m.axim", "--signal", "ramp:1000", "--cycles", "100"};
  auto const with = [&](std::string const& command) {
    auto arguments = ramp;
    arguments.insert(arguments.end(), {"--at", command});
    return run_axisc(arguments, there);
  };
  // A ramp of one unit per cycle shows the delay: 99 less 10 cycles of X and Y; Z is off.
  CHECK(line_from_end(run_axisc(ramp, there).out) == "89,89,99");
  CHECK(line_from_end(with("0:#FILTER OFF").out) == "99,99,99");
  CHECK(line_from_end(with("0:#FILTER ON [ORDER=40]").out) == "79,59,99");
  CHECK(line_from_end(with("0:#FILTER ON [ORDER_TIME=30000 SHARE=50]").out) == "84,84,99");
  CHECK(line_from_end(run_axisc({"run", "m.axim", "--signal", "ramp:1000", "--cycles", "100", "--at",
                                 "0:#FILTER ON [ORDER=30 SHARE=50]", "--at", "0:#FILTER [ORDER=30]"},
                                there)
                          .out) == "84,84,99");
  // NoVib at 50 Hz, twice a period of 20 cycles: h = 20.
  CHECK(line_from_end(with("0:#FILTER ON [HSC]").out) == "89,89,79");
}

TEST_CASE("a command in motion fades") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  auto const outcome = run_axisc({"run", "m.axim", "--signal", "ramp:1000", "--cycles", "2000", "--at",
                                  "100:#FILTER OFF", "--at", "1200:#FILTER ON"},
                                 there);
  INFO(outcome.err);
  CHECK(line_from_end(outcome.out) == "1989,1989,1999");
  CHECK(line_from_end(outcome.out, 800) == "1199,1199,1199");
}

TEST_CASE("what commands are refused") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  auto const check = [&](std::vector<std::string> const& commands, std::string const& expected) {
    std::vector<std::string> arguments{"run", "m.axim", "--signal", "ramp:1000"};
    for (auto const& command : commands) arguments.insert(arguments.end(), {"--at", command});
    auto const outcome = run_axisc(arguments, there);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  };
  check({"0:#FILTER ON [ORDER=40]", "5:#FILTER [SHARE=50]"}, "asks for #FILTER ON [ORDER=40 SHARE=50]");
  check({"0:#FILTER ON [ORDER=41]"},
        "it has: #FILTER ON, #FILTER ON [ORDER=40], #FILTER ON [ORDER=30 SHARE=50], #FILTER ON [HSC]");
  check({"10:#FILTER ON [ORDERS=40]"}, "no keyword");
  check({"x:#FILTER ON"}, "expected CYCLE:COMMAND");
  check({"#FILTER ON"}, "expected CYCLE:COMMAND");
  check({"20:#FILTER OFF", "21:#FILTER ON"}, "at cycle 21: a filter is still changing over");
}

TEST_CASE("the response follows the commands") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  auto const at_50_hertz = [&](std::vector<std::string> const& more) {
    std::vector<std::string> arguments{"response", "m.axim", "--axis", "Z", "--frequencies", "0,50"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_axisc(arguments, there).out;
  };
  CHECK_THAT(at_50_hertz({}), Catch::Matchers::EndsWith("\nZ,50,1,0,0,0,0\n"));
  CHECK_THAT(at_50_hertz({"--at", "7:#FILTER ON [HSC]"}), Catch::Matchers::Contains("\nZ,0,1,0,0.02,0,0\n"));
}

TEST_CASE("velocities become additive velocities and drive increments") {
  TemporaryFolder const folder;
  auto const there = compiled_with_switches(folder);
  auto const outcome = run_axisc({"run", "m.axim", "--port", "velocity", "--cycles", "2"}, there);
  CHECK_THAT(outcome.out, Catch::Matchers::StartsWith("X.v_add,X.increments\n-0.0491569"));
  // A measured velocity far beyond every limit: ±1000/1000 · 500000 µm/s, and 60/36 increments per µm/s.
  folder.write("v.csv", "X.v_motor,X.v_set\n1e9,0\n-1e9,0\n");
  auto const limited = run_axisc({"run", "m.axim", "--input", "v.csv"}, there);
  CHECK(limited.out.substr(0, 40) == "X.v_add,X.increments\n-500000,-833333.333");
  CHECK_THAT(run_axisc({"response", "m.axim", "--axis", "Y", "--port", "velocity"}, there).err,
             Catch::Matchers::Contains("uses velocities"));
}

}  // namespace switching_test
