#include "cli/compiled_machine.hpp"
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

namespace run_test {

using namespace axisc::test;

namespace {

std::vector<std::string> lines(std::string const& text) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin < text.size();) {
    auto const end = std::min(text.find('\n', begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

}  // namespace

TEST_CASE("a step goes through every axis") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const outcome = run_axisc({"run", "m.axim", "--signal", "step", "--cycles", "12"}, there);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  check_golden("tests/cli/data/golden/run.csv", outcome.out);
  CHECK(lines_of(run_axisc({"run", "m.axim"}, there).out) == 257);
}

TEST_CASE("the interface port shows the axes that have a filter there") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const rows = lines(run_axisc({"run", "m.axim", "--port", "interface", "--cycles", "3"}, there).out);
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] == "X.interface");
}

TEST_CASE("a file is the same as the signal it holds") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  std::string csv = "Y,X\n";
  for (int i = 0; i < 50; ++i) csv += "1,1\n";
  folder.write("in.csv", csv);
  REQUIRE(run_axisc({"run", "m.axim", "--input", "in.csv", "--output", "out.csv"}, there).status == 0);
  auto const from_file = lines(folder.read("out.csv"));
  auto const from_signal = lines(run_axisc({"run", "m.axim", "--cycles", "50"}, there).out);
  REQUIRE(from_file.size() == from_signal.size());
  for (std::size_t i = 0; i < from_file.size(); ++i) {
    auto const comma = from_signal[i].find(',');
    CHECK(from_file[i] == from_signal[i].substr(comma + 1) + "," + from_signal[i].substr(0, comma));
  }
}

TEST_CASE("both ports of an axis in one file, from standard input") {
  TemporaryFolder const folder;
  auto there = compiled(folder);
  there.input = "X,X.interface\n1000000000,0\n1000000000,1\n";
  auto const rows = lines(run_axisc({"run", "m.axim", "--input", "-", "--reset", "1e9"}, there).out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0] == "X,X.interface");
  CHECK(rows[1] == "1000000000,0");
  CHECK_THAT(rows[2], Catch::Matchers::StartsWith("1000000000,0."));
}

TEST_CASE("after a reset the position stands exactly") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const rows = lines(run_axisc({"run", "m.axim", "--amplitude", "123456789.25", "--reset",
                                     "123456789.25", "--cycles", "100"},
                                    there)
                              .out);
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i] == "123456789.25,123456789.25");
}

TEST_CASE("setpoints that are no numbers are replaced, and that is said") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("in.csv", "Y\n5\nnan\n1e300\n6\n");
  auto const outcome = run_axisc({"run", "m.axim", "--input", "in.csv"}, there);
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "Y\n5\n5\n5\n6\n");
  CHECK_THAT(outcome.err, Catch::Matchers::StartsWith("axisc: warning: 2 inputs were NaN") &&
                              Catch::Matchers::Contains("cycle 1;"));
  CHECK(run_axisc({"run", "m.axim", "--input", "in.csv", "--quiet"}, there).err.empty());
  folder.write("one.csv", "Y\n5\n6\nnan\n");
  CHECK_THAT(run_axisc({"run", "m.axim", "--input", "one.csv"}, there).err,
             Catch::Matchers::Contains("warning: an input in cycle 2 was NaN"));
}

TEST_CASE("what run refuses") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("bad.csv", "X\n1\n1,5\n");
  folder.write("other.csv", "X,Z\n1,2\n");
  folder.write("side.csv", "Y.interface\n1\n");
  folder.write("good.csv", "X\n1\n");
  folder.write("old.csv", "old");
  auto const check = [&](std::vector<std::string> arguments, std::string const& expected) {
    arguments.insert(arguments.begin(), {"run", "m.axim"});
    auto const outcome = run_axisc(arguments, there);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  };
  check({"--input", "bad.csv", "--output", "old.csv"},
        "error[AX9005]: bad.csv:3:3: the number of fields is 2");
  CHECK(folder.read("old.csv") == "old");
  check({"--input", "other.csv"},
        "error[AX9005]: other.csv:1:3: the image does not use column \"Z\"; it uses X, X.interface, Y");
  check({"--input", "side.csv"}, "error[AX9005]: side.csv:1:1");
  check({"--input", "missing.csv"}, "error[AX9001]");
  check({"--input", "."}, "error[AX9001]");
  check({"--input", "good.csv", "--signal", "step"}, "--signal cannot be used together with --input");
  check({"--signal", "sin:1"}, "\"sin:1\" is not a signal");
  check({"--cycles", "-1"}, "--cycles needs a positive whole number");
  check({"--amplitude", "1,5"}, "--amplitude needs a number");
  check({"--port", "velocity"}, "uses velocities");
  check({"--port", "motor"}, "--port does not know \"motor\"");
  check({"--at", "0:#FILTER ON [HSC]"}, "has a FIR or HSC filter");
}

TEST_CASE("a command after the last cycle is refused") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/switching/machine.json";
  REQUIRE(run_axisc({"compile", machine, "-o", "m.axim", "--quiet"}, there).status == 0);
  auto const signal = run_axisc({"run", "m.axim", "--cycles", "3", "--at", "3:#FILTER OFF"}, there);
  CHECK(signal.status == 2);
  CHECK(signal.out.empty());
  folder.write("in.csv", "X\n1\n2\n");
  auto const file =
      run_axisc({"run", "m.axim", "--input", "in.csv", "--at", "9:#FILTER OFF", "-o", "out.csv"}, there);
  CHECK(file.status == 2);
  CHECK_FALSE(std::filesystem::exists(folder / "out.csv"));
}

TEST_CASE("columns that are separated by semicolons are named as such") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("in.csv", "X;Y\n1;2\n");
  CHECK_THAT(run_axisc({"run", "m.axim", "--input", "in.csv"}, there).err,
             Catch::Matchers::Contains("separated by semicolons"));
}

TEST_CASE("rows begin with the time where asked for, and text is aligned with four digits") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 2\nkopf.log_achs_name "
               "Long_axis_name\n");
  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "x.lis", "--cycle-time", "250us", "-o", "x.axim", "--quiet"}, there).status ==
          0);
  auto const csv = run_axisc({"run", "x.axim", "--time", "--cycles", "4", "--amplitude", "3"}, there);
  CHECK(csv.out == "time_s,Long_axis_name\n0,1\n0.00025,2\n0.0005,3\n0.00075,3\n");
  auto const text =
      run_axisc({"run", "x.axim", "--time", "--format", "text", "--cycles", "3", "--amplitude", "1"}, there);
  CHECK(text.out == "time_s      Long_axis_name\n0           0.3333\n0.00025     0.6667\n0.0005      1\n");
  CHECK(run_axisc({"run", "x.axim", "--format", "text", "--cycles", "1"}, there).out ==
        "Long_axis_name\n0.3333\n");
}

}  // namespace run_test
