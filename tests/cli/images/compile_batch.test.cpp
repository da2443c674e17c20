// Images of several machines in one process.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <map>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace compile_batch_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string mistakes() {
  return read_source_file("tests/cli/data/mistakes.lis");
}

std::string list(int frequency) {
  return "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 " +
         std::to_string(frequency) + "\nfilter[0].prototype CRIT_DAMPING\nEnde\n";
}

class Plant {
 public:
  Plant() {
    for (int i = 1; i <= 9; ++i) folder.write("line/axis" + std::to_string(i) + ".lis", list(i));
    folder.write("mill/machine.json", R"({"cycle_time_us": 500, "axes": [{"name": "X", "list": "x.lis"}]})");
    folder.write("mill/x.lis", list(30));
    folder.write("part.nc", "N10 M30\n");
  }
  [[nodiscard]] Outcome compile(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"compile", "--cycle-time", "1ms"});
    return run_axisc(arguments, in_folder(folder.path()));
  }
  /// Names and times of change of all images.
  [[nodiscard]] std::map<std::string, fs::file_time_type> images(std::string const& name) const {
    std::map<std::string, fs::file_time_type> result;
    for (auto const& entry : fs::recursive_directory_iterator(folder / name)) {
      if (entry.is_regular_file()) {
        result.emplace(fs::relative(entry.path(), folder / name).string(), entry.last_write_time());
      }
    }
    return result;
  }
  TemporaryFolder folder;
};

}  // namespace

TEST_CASE("a batch mirrors the folders of its inputs") {
  Plant const plant;
  auto const outcome = plant.compile({".", "--output-folder", "out", "-j", "3"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "images: 10 written, 0 unchanged, 0 not written\n");
  auto const images = plant.images("out");
  CHECK(images.size() == 10);
  CHECK(images.contains("line/axis3.axim"));
  CHECK(images.contains("mill/machine.axim"));
  // The same bytes as one by one.
  REQUIRE(plant.compile({"line/axis3.lis", "-o", "alone.axim"}).status == 0);
  CHECK(plant.folder.read("alone.axim") == plant.folder.read("out/line/axis3.axim"));
  // Names may begin elsewhere.
  REQUIRE(plant.compile({"mill", "--output-folder", "below", "--input-folder", "mill"}).status == 0);
  CHECK(plant.images("below").contains("machine.axim"));
}

TEST_CASE("a list of another kind has no image") {
  TemporaryFolder const folder;
  folder.write("lists/x.lis", list(30));
  folder.write("lists/wz.lis", "wz[1].laenge 0 ( P-TOOL-00003\n");
  auto const compile = [&folder](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"compile", "--cycle-time", "1ms"});
    return run_axisc(arguments, in_folder(folder.path()));
  };
  auto const batch = compile({"lists", "--output-folder", "out", "--depfile", "out.d"});
  CHECK(batch.status == 0);
  CHECK_THAT(batch.err, !Catch::Matchers::Contains("[AX") &&
                            Catch::Matchers::EndsWith("images: 1 written, 0 unchanged, 0 not written\n"));
  CHECK(fs::exists(folder / "out/lists/x.axim"));
  CHECK_FALSE(fs::exists(folder / "out/lists/wz.axim"));
  CHECK_THAT(folder.read("out.d"), !Catch::Matchers::Contains("wz"));
  auto const again = compile({"lists", "--output-folder", "out"});
  CHECK(again.status == 0);
  CHECK_THAT(again.err, Catch::Matchers::EndsWith("images: 0 written, 1 unchanged, 0 not written\n"));
  auto const alone = compile({"lists/wz.lis", "-o", "wz.axim"});
  CHECK(alone.status == 2);
  CHECK_THAT(alone.err, Catch::Matchers::Contains("is not an axis list"));
  CHECK_FALSE(fs::exists(folder / "wz.axim"));
}

TEST_CASE("an image that would be the same is not touched") {
  Plant const plant;
  REQUIRE(plant.compile({".", "--output-folder", "out"}).status == 0);
  auto const before = plant.images("out");
  plant.folder.write("line/axis4.lis", list(44));
  auto const outcome = plant.compile({".", "--output-folder", "out"});
  CHECK(outcome.err == "images: 1 written, 9 unchanged, 0 not written\n");
  auto const after = plant.images("out");
  for (auto const& [name, time] : before) CHECK((after.at(name) != time) == (name == "line/axis4.axim"));

  REQUIRE(plant.compile({"line/axis1.lis", "-o", "one.axim"}).status == 0);
  auto const time = fs::last_write_time(plant.folder / "one.axim");
  CHECK_THAT(plant.compile({"line/axis1.lis", "-o", "one.axim"}).err,
             Contains("one.axim: unchanged, axes: 1"));
  CHECK(fs::last_write_time(plant.folder / "one.axim") == time);
  // One bit is enough.
  plant.folder.write("one.axim", plant.folder.read("one.axim").substr(1) + "x");
  CHECK_THAT(plant.compile({"line/axis1.lis", "-o", "one.axim"}).err, Contains("one.axim: written"));
}

TEST_CASE("a batch has one rule for each image") {
  Plant const plant;
  plant.folder.write("axisc.json", R"({"build": "V3.1.3080.00"})");
  plant.folder.write("line/axis9.lis", mistakes());
  CHECK(
      plant.compile({"line/axis9.lis", "mill", "missing.lis", "--output-folder", "out", "--depfile", "out.d"})
          .status == 2);
  CHECK(plant.folder.read("out.d") ==
        "out/line/axis9.axim: \\\n  line/axis9.lis \\\n  axisc.json\n"
        "out/mill/machine.axim: \\\n  mill/machine.json \\\n  mill/x.lis \\\n  axisc.json\n"
        "out/missing.axim: \\\n  missing.lis \\\n  axisc.json\n");
}

TEST_CASE("one bad input does not stop the others") {
  Plant const plant;
  plant.folder.write("line/axis2.lis", mistakes());
  auto const errors = plant.compile({".", "--output-folder", "out"});
  CHECK(errors.status == 1);
  CHECK_THAT(errors.err, Contains("line/axis2.lis:") && Contains("9 written, 0 unchanged, 1 not written"));
  CHECK_FALSE(plant.images("out").contains("line/axis2.axim"));
  // Without the option a list has no cycle time: a failure of its own.
  auto const outcome =
      run_axisc({"compile", ".", "--output-folder", "other"}, in_folder(plant.folder.path()));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("the NC cycle time for line/axis1.lis is not known") &&
                              Contains("1 written, 0 unchanged, 9 not written"));
}

TEST_CASE("names that cannot be are usage errors, and nothing is written") {
  Plant const plant;
  plant.folder.write("line/axis1.json", R"({"axes": []})");
  auto const check = [&](std::vector<std::string> const& arguments, std::string const& expected) {
    auto const outcome = plant.compile(arguments);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(expected));
    CHECK_FALSE(fs::exists(plant.folder / "out"));
  };
  check({"line", "--output-folder", "out"},
        "line/axis1.json and line/axis1.lis would both be written to out/line/axis1.axim");
  check({"mill", "--output-folder", "out", "--input-folder", "line"}, "is not below");
  check({"-", "--output-folder", "out"}, "an image from standard input has no name");
  check({"mill", "--output-folder", "out", "-o", "x.axim"}, "cannot be used together");
  check({"part.nc", "--output-folder", "out"}, "is an NC program");
  check({"mill/x.lis", "-o", "x.axim", "--input-folder", "mill"}, "--input-folder needs --output-folder");
}

TEST_CASE("a batch without any input that is there fails cleanly") {
  Plant const plant;
  plant.folder.write("names.txt", "missing.lis\n");
  for (std::string const format : {"text", "sarif"}) {
    auto const batch = plant.compile({"@names.txt", "--output-folder", "out", "--format", format});
    CHECK(batch.status == 2);
    CHECK_THAT(batch.err, Contains("cannot read missing.lis, named in names.txt:1"));
    CHECK(plant.compile({"@names.txt", "-o", "x.axim", "--format", format}).status == 2);
  }
}

TEST_CASE("findings of a batch come in input order, for every number of threads") {
  Plant const plant;
  for (int i = 1; i <= 9; i += 2) plant.folder.write("line/axis" + std::to_string(i) + ".lis", mistakes());
  for (std::string const format : {"text", "json", "jsonl", "sarif", "github", "gitlab", "junit"}) {
    auto const one = plant.compile({".", "--output-folder", "one", "-j", "1", "--format", format});
    auto const eight = plant.compile({".", "--output-folder", "eight", "-j", "8", "--format", format});
    CHECK(one.status == 1);
    CHECK(one.err == eight.err);
  }
}

TEST_CASE("an interrupted batch leaves whole files only") {
  Plant const plant;
  for (int i = 0; i < 150; ++i) plant.folder.write("many/" + std::to_string(i) + ".lis", list(1 + i % 400));
  for (int const signal : {SIGINT, SIGTERM, SIGKILL}) {
    for (unsigned const milliseconds : {30U, 120U}) {
      auto const child = ::fork();
      REQUIRE(child >= 0);
      if (child == 0) {
        if (::chdir(plant.folder.path().c_str()) != 0) ::_exit(126);
        ::execl(AXISC_PROGRAM, AXISC_PROGRAM, "compile", "many", "--output-folder", "out", "--cycle-time",
                "1ms", "--quiet", "-j", "6", nullptr);
        ::_exit(127);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      ::kill(child, signal);
      int status = 0;
      REQUIRE(::waitpid(child, &status, 0) == child);
      if (!fs::exists(plant.folder / "out")) continue;
      for (auto const& [name, time] : plant.images("out")) {
        bool const is_left = name.find(".axisc-") != std::string::npos;
        // Nobody can clean up behind SIGKILL; but no file of a real name is half.
        CHECK((!is_left || signal == SIGKILL));
        if (!is_left) CHECK(run_axisc({"inspect", plant.folder / ("out/" + name)}).status == 0);
      }
      fs::remove_all(plant.folder / "out");
    }
  }
}

}  // namespace compile_batch_test
