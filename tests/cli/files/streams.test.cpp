// Full disks: one line, exit status 2. Closed pipes: silence, exit status 2.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <sys/mount.h>

namespace streams_test {

using namespace axisc::test;

namespace {

std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";

}  // namespace

TEST_CASE("standard output on a full disk") {
  TemporaryFolder const folder;
  auto const image = folder / "m.axim";
  REQUIRE(run_axisc({"compile", machine, "-o", image}).status == 0);
  for (std::vector<std::string> const& arguments : {std::vector<std::string>{"lint", machine},
                                                    {"lint", machine, "--format", "json"},
                                                    {"inspect", image},
                                                    {"run", image},
                                                    {"run", image, "--cycles", "100000"},
                                                    {"response", image},
                                                    {"explain", "--all"},
                                                    {"--help"}}) {
    auto const outcome = run_axisc(
        arguments, {.folder = ".", .input = {}, .out = "/dev/full", .variables = {}, .closed_pipe = false});
    INFO(arguments[0]);
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "axisc: error[AX9002]: cannot write standard output: no space is left\n");
  }
}

TEST_CASE("a pipe that nobody reads ends the program without a word") {
  TemporaryFolder const folder;
  auto const image = folder / "m.axim";
  REQUIRE(run_axisc({"compile", machine, "-o", image}).status == 0);
  auto const outcome =
      run_axisc({"run", image, "--cycles", "10000000"},
                {.folder = ".", .input = {}, .out = {}, .variables = {}, .closed_pipe = true});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.empty());
}

TEST_CASE("a disk that fills up while a file is written") {
  TemporaryFolder const folder;
  std::filesystem::create_directories(folder / "small");
  if (::mount("none", (folder / "small").c_str(), "tmpfs", 0, "size=64k") != 0) {
    WARN("no small file system can be mounted here");
    return;
  }
  struct Unmount {
    std::string path;
    ~Unmount() { ::umount(path.c_str()); }
  };
  Unmount const unmount{folder / "small"};
  auto const image = folder / "m.axim";
  REQUIRE(run_axisc({"compile", machine, "-o", image}).status == 0);
  folder.write("small/out.csv", "old");
  auto const outcome = run_axisc(
      {"run", image, "--signal", "sine:1", "--cycles", "100000", "--output", folder / "small/out.csv"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Catch::Matchers::Contains("AX9002") && Catch::Matchers::Contains("no space is left"));
  CHECK(lines_of(outcome.err) == 1);
  CHECK(folder.read("small/out.csv") == "old");
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "small"), {}) == 1);
}

}  // namespace streams_test
