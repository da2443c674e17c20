#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <sstream>
#include <tuple>

namespace export_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string const data = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/";
std::string const mill = std::string(AXISC_SOURCE_DIR) + "/samples/mill/machine.json";

Outcome export_to(std::string const& input, std::string const& folder) {
  return run_axisc({"export", input, "--to", "c", "-o", folder});
}

/// Numbers of a text in which blanks, commas and lines separate them.
std::vector<double> numbers_of(std::string text) {
  for (char& letter : text) letter = letter == ',' ? ' ' : letter;
  std::istringstream in(text);
  std::vector<double> numbers;
  for (std::string word; in >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

/// What a step of 10000 on all axes gives, without the line of names.
std::vector<double> step_of(std::string const& image) {
  auto const run = run_axisc({"run", image, "--signal", "step", "--amplitude", "10000", "--cycles", "100"});
  REQUIRE(run.status == 0);
  std::vector<double> setpoints;
  std::istringstream lines(run.out.substr(run.out.find('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    auto const values = numbers_of(line);
    setpoints.insert(setpoints.end(), values.begin(), values.end());
  }
  return setpoints;
}

/// What the example of an export prints, compiled with this compiler; empty where the compiler refuses a
/// source.
std::string printed_by_example(TemporaryFolder const& folder, std::string const& compiler) {
  auto const run =
      "cd '" + (folder / "c") + "' && " + compiler +
      " -pedantic -Wall -Wextra -Werror -O2 example.c machine.c axisrt_c.c -o example && ./example > out";
  return std::system(run.c_str()) == 0 ? folder.read("c/out") : "";
}

}  // namespace

TEST_CASE("the sources of a machine compute what run computes, as C99 and as C++14") {
  TemporaryFolder const folder;
  auto const outcome = export_to(mill, folder / "c");
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err,
             Contains("axisrt_c.c, axisrt_c.h, example.c, machine.c, machine.h written, axes: 4"));
  REQUIRE(run_axisc({"compile", mill, "-o", folder / "mill.axim", "--quiet"}).status == 0);
  auto const expected = step_of(folder / "mill.axim");
  REQUIRE(expected.size() == 400);
  for (auto const* const compiler : {"cc -std=c99", "c++ -std=c++14 -x c++"}) {
    INFO(compiler);
    CHECK(numbers_of(printed_by_example(folder, compiler)) == expected);
  }
}

TEST_CASE("an image, its machine and its folder are exported as the same bytes") {
  TemporaryFolder const folder;
  REQUIRE(run_axisc({"compile", mill, "-o", folder / "mill.axim", "--quiet"}).status == 0);
  REQUIRE(run_axisc({"compile", mill, "--strip", "-o", folder / "stripped.axim", "--quiet"}).status == 0);
  auto const samples = std::string(AXISC_SOURCE_DIR) + "/samples/mill";
  int number = 0;
  for (std::string const& input : {mill, samples, folder / "mill.axim", folder / "mill.axim"}) {
    REQUIRE(export_to(input, folder / std::to_string(number++)).status == 0);
  }
  for (auto const* const file : {"axisrt_c.c", "axisrt_c.h", "example.c", "machine.c", "machine.h"}) {
    for (int other = 1; other < number; ++other) {
      CHECK(folder.read("0/" + std::string(file)) == folder.read(std::to_string(other) + '/' + file));
    }
  }
  CHECK_THAT(folder.read("0/machine.c"),
             Contains("machine_image_size = " + std::to_string(folder.read("stripped.axim").size())));
  REQUIRE(run_axisc({"export", mill, "--to", "c", "-o", folder / "whole", "--complete"}).status == 0);
  CHECK_THAT(folder.read("whole/machine.c"),
             Contains("machine_image_size = " + std::to_string(folder.read("mill.axim").size())));
}

TEST_CASE("the header of an export names axes and banks with their numbers") {
  TemporaryFolder const folder;
  REQUIRE(export_to(mill, folder / "c").status == 0);
  check_golden("tests/cli/data/golden/export-machine.txt", folder.read("c/machine.h"));
}

TEST_CASE("names cannot end the comment of an exported header") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\n");
  auto const input = folder.write(
      "machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X*/ int", "list": "x.lis"}]})");
  REQUIRE(export_to(input, folder / "c").status == 0);
  CHECK_THAT(folder.read("c/machine.h"), Contains("X / int") && !Contains("X*/"));
}

TEST_CASE("export says what is missing or wrong and writes nothing then") {
  TemporaryFolder const folder;
  auto const refused = [](std::vector<std::string> const& arguments, std::string const& why) {
    auto const outcome = run_axisc(arguments);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains(why));
  };
  refused({"export"}, "INPUT");
  refused({"export", mill, "-o", folder / "c"}, "--to");
  refused({"export", mill, "--to", "c"}, "-o OUT");
  refused({"export", mill, "--to", "c", "--binaries", "none", "-o", folder / "c"}, "--binaries is for");
  refused({"export", mill, "--to", "c", "--plain-integers", "-o", folder / "c"}, "--plain-integers is for");
  refused({"export", mill, "--to", "fmu3", "--binaries", "linux64,amiga", "-o", folder / "c"}, "amiga");
  // Before the machine is looked at, whose findings would have another status.
  refused({"export", data + "mistakes.lis", "--to", "fmu3", "--binaries", "none,linux64", "-o", folder / "c"},
          "none or auto alone");
  refused({"export", mill, "--to", "c", "-o", folder.write("a-file", "") + "/c"}, "cannot be made");
  refused({"export", mill, "--to", "fmu2", "--binaries", "none", "-o", folder / "none/m.fmu"}, "AX9002");
  refused({"export", mill, "--to", "pascal", "-o", folder / "c"}, "pascal");
  refused({"export", folder / "none.axim", "--to", "c", "-o", folder / "c"}, "none.axim");
  refused({"export", folder.write("bad.axim", "AXIM and no more"), "--to", "c", "-o", folder / "c"},
          "AX9004");
  refused({"export", mill, "--to", "c", "-o", folder.write("file", "")}, "AX9002");
  auto const list = folder.write("machine.c", "kopf.achs_nr 1\n");
  refused({"export", list, "--to", "c", "--cycle-time", "1ms", "-o", folder / ""}, "AX9002");
  CHECK(folder.read("machine.c") == "kopf.achs_nr 1\n");
  auto const outcome =
      run_axisc({"export", data + "mistakes.lis", "--to", "c", "--cycle-time", "1ms", "-o", folder / "c"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("error[AX"));
  CHECK_FALSE(fs::exists(folder / "c"));
}

TEST_CASE("an image has its own cycle time: another one is refused, the same one is not") {
  TemporaryFolder const folder;
  auto const image = folder / "mill.axim";
  REQUIRE(run_axisc({"compile", mill, "-o", image, "--quiet"}).status == 0);
  CHECK(run_axisc({"export", image, "--to", "c", "--cycle-time", "1ms", "-o", folder / "same"}).status == 0);
  for (std::vector<std::string> const& command :
       std::vector<std::vector<std::string>>{{"export", image, "--to", "c", "-o", folder / "other"},
                                             {"response", image},
                                             {"plot", image, "-o", folder / "other.svg"}}) {
    auto arguments = command;
    arguments.insert(arguments.end(), {"--cycle-time", "2ms"});
    auto const outcome = run_axisc(arguments);
    INFO(command.front());
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("was compiled for an NC cycle time of 1000 µs, not 2000 µs"));
    CHECK(outcome.out.empty());
  }
  CHECK_FALSE(fs::exists(folder / "other"));
  CHECK_FALSE(fs::exists(folder / "other.svg"));
}

TEST_CASE("an FMU is the same bytes each time") {
  TemporaryFolder const folder;
  REQUIRE(run_axisc({"compile", mill, "-o", folder / "mill.axim", "--quiet"}).status == 0);
  auto const outcome =
      run_axisc({"export", mill, "--to", "fmu3", "--binaries", "none", "-o", folder / "mill.fmu"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  auto const fmu = folder.read("mill.fmu");
  CHECK(outcome.err == (folder / "mill.fmu") + ": written, axes: 4, libraries: none, " +
                           std::to_string(fmu.size()) + " bytes\n");
  fs::create_directory(folder / "again");
  auto const again = folder / "again/mill.fmu";
  REQUIRE(
      run_axisc({"export", folder / "mill.axim", "--to", "fmu3", "--binaries", "none", "-o", again}).status ==
      0);
  CHECK(folder.read("again/mill.fmu") == fmu);
}

TEST_CASE("libraries in an FMU are the same bytes each time", "[posix]") {
  TemporaryFolder const folder;
  fs::create_directory(folder / "again");
  for (auto const& [compiler, platform, library] :
       {std::tuple("cc", "linux64", "mill.so"),
        std::tuple("x86_64-w64-mingw32-gcc-posix", "win64", "mill.dll")}) {
    if (std::system((std::string("command -v ") + compiler + " >/dev/null").c_str()) != 0) continue;
    auto const with_library = [&](std::string const& file) {
      auto const made =
          run_axisc({"export", mill, "--to", "fmu2", "--binaries", platform, "-o", folder / file});
      CHECK_THAT(made.err, Contains(std::string("libraries: binaries/") + platform + "/" + library));
      return folder.read(file);
    };
    CHECK(with_library("mill.fmu") == with_library("again/mill.fmu"));
  }
}

TEST_CASE("a compiler that is missing is named, and the FMU is written without its library") {
  TemporaryFolder const folder;
  auto surroundings = in_folder(folder.path());
  surroundings.variables = {"PATH=" + folder.path()};
  auto const outcome = run_axisc({"export", mill, "--to", "fmu3", "-o", "mill.fmu"}, surroundings);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err,
             Contains("linux64: no library, because cc cannot be run") &&
                 Contains("win64: no library, because x86_64-w64-mingw32-gcc-posix cannot be run") &&
                 Contains("libraries: none"));
  CHECK(folder.read("mill.fmu").substr(0, 2) == "PK");
}

}  // namespace export_test
