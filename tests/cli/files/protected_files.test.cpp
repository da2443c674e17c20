// No output of any command replaces an input, another output or a secret key, under whatever name.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <map>

namespace protected_files_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

/// An image m.axim, what it was made of, and a file of each kind that a command reads.
Surroundings prepared(TemporaryFolder const& folder) {
  Surroundings there = in_folder(folder.path());
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})");
  folder.write("x.lis", "Ende\n");
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim"}, there).status == 0);
  folder.write("in.csv", "X\n0\n1\n");
  folder.write("names.txt", "m.json\n");
  folder.write("axisc.json", "{}\n");
  folder.write("alone.lis", "Ende\n");
  REQUIRE(run_axisc({"keygen", "plant.key"}, there).status == 0);
  REQUIRE(
      run_axisc({"run", "m.axim", "--cycles", "9", "--record", "r.axrd", "-o", "out.csv"}, there).status ==
      0);
  fs::create_symlink("m.axim", folder / "link.axim");
  fs::create_hard_link(folder / "m.axim", folder / "hard.axim");
  return there;
}

std::map<std::string, std::string> contents(TemporaryFolder const& folder) {
  std::map<std::string, std::string> all;
  for (auto const& entry : fs::recursive_directory_iterator(folder.path())) {
    auto const name = fs::path(entry).lexically_relative(folder.path()).string();
    if (entry.is_regular_file()) all.emplace(name, folder.read(name));
  }
  return all;
}

}  // namespace

TEST_CASE("no output replaces an input, another output or a key") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  auto const before = contents(folder);
  for (Arguments const& arguments : std::vector<Arguments>{
           {"compile", "m.json", "-o", "o.axim", "--depfile", "x.lis"},
           {"compile", "m.json", "-o", "o.axim", "--depfile", "m.json"},
           {"compile", "m.json", "-o", "o.axim", "--depfile", "./o.axim"},
           {"compile", "m.json", "-o", "o.axim", "--depfile", "axisc.json"},
           {"compile", "@names.txt", "-o", "names.txt"},
           {"compile", "m.json", "-o", "plant.key"},
           {"compile", "m.json", "--output-folder", "new", "--depfile", "x.lis"},
           {"compile", "m.json", "--output-folder", "new", "--depfile", "new/m.axim"},
           {"run", "m.axim", "-o", "m.axim"},
           {"run", "m.axim", "-o", "link.axim"},
           {"run", "m.axim", "-o", "hard.axim"},
           {"run", "m.axim", "--record", "m.axim", "-o", "new.csv"},
           {"run", "m.axim", "--input", "in.csv", "-o", "in.csv"},
           {"run", "m.axim", "--record", "both", "-o", "./both"},
           {"run", "m.axim", "-o", "plant.key"},
           {"replay", "m.axim", "r.axrd", "-o", "r.axrd"},
           {"sign", "m.axim", "--key", "plant.key", "-o", "plant.key"},
           {"sign", "m.axim", "--key", "plant.key", "-o", "hard.axim"},
           {"lint", "m.json", "--write-baseline", "axisc.json"},
           {"lint", "m.json", "--write-baseline", "x.lis"},
           {"lint", "@names.txt", "--write-baseline", "names.txt"},
       }) {
    auto const outcome = run_axisc(arguments, there);
    std::string line;
    for (auto const& word : arguments) line += word + " ";
    INFO(line << outcome.out << outcome.err);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("AX9002") && (Contains("overwritten") || Contains("same file")));
    CHECK(contents(folder) == before);
  }
}

TEST_CASE("no picture, page or table replaces a file of the machine or of its settings", "[posix]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const samples = fs::path(AXISC_SOURCE_DIR) / "samples";
  fs::copy(samples / "mill", folder.path());
  fs::copy(samples / "mill", folder / "before");
  folder.write("schema.json", R"({"version": 1, "parameters": []})");
  folder.write("axisc.json", R"({"schema": ["schema.json"]})");
  std::vector<Arguments> const commands = {
      {"plot", "machine.json", "-o"},
      {"plot", "machine.json", "--before", "before/machine.json", "-o"},
      {"plot", "machine.json", "--kind", "circle", "--feed", "1000", "-o"},
      {"report", "machine.json", "-o"},
      {"report", "machine.json", "--before", "before/machine.json", "-o"},
      {"suggest", "machine.json", "--axis", "X", "--resonance", "48Hz", "-o"},
      {"simulate", "machine.json", "--program", "part.nc", "-o"},
      {"compile", "machine.json", "-o"},
      {"lint", "machine.json", "--write-baseline"}};
  folder.write("before/axisc.json", R"({"schema": ["../schema.json"]})");
  auto const before = contents(folder);
  for (std::string const file : {"machine.json", "default.lis", "x.lis", "part.nc", "axisc.json",
                                 "schema.json", "before/y.lis", "before/axisc.json"}) {
    for (auto arguments : commands) {
      if (file.starts_with("before/") && arguments[2] != "--before") continue;
      fs::create_symlink(file, folder / "out.svg");
      arguments.emplace_back("out.svg");
      auto const outcome = run_axisc(arguments, there);
      fs::remove(folder / "out.svg");
      INFO(arguments.front() << " -o " << file << ": " << outcome.err);
      CHECK(outcome.status == 2);
      CHECK_THAT(outcome.err, Contains("AX9002") && Contains("overwritten"));
      CHECK(contents(folder) == before);
    }
  }
  // Also where the page is about errors.
  folder.write("x.lis", "filter[0].enable 1\nfilter[0].type NONE_SUCH\nEnde\n");
  auto const wrong = contents(folder);
  CHECK(run_axisc({"report", "machine.json", "-o", "y.lis"}, there).status == 2);
  CHECK(contents(folder) == wrong);
}

TEST_CASE("a device is nobody's file") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  CHECK(run_axisc({"compile", "m.json", "-o", "/dev/null", "--depfile", "/dev/null"}, there).status == 0);
  CHECK(run_axisc({"run", "m.axim", "-o", "/dev/null", "--record", "/dev/null"}, there).status == 0);
}

TEST_CASE("a name with a line break cannot be in a dependency file", "[posix]") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  folder.write("a\nb: evil.lis", "Ende\n");
  auto const outcome = run_axisc(
      {"compile", "a\nb: evil.lis", "-o", "o.axim", "--depfile", "d", "--cycle-time", "1ms"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("line break"));
  CHECK_FALSE(fs::exists(folder / "d"));
  CHECK_FALSE(fs::exists(folder / "o.axim"));
}

}  // namespace protected_files_test
