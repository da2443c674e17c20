#include "cli/options/inputs.hpp"

#include "cli/options/machine_outline.hpp"
#include "cli/temporary_folder.hpp"

#include <algorithm>

using namespace axisc::cli;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names(axisc::test::TemporaryFolder const& folder,
                               std::vector<std::string> const& paths) {
  std::vector<std::string> result;
  for (auto const& path : paths) result.push_back(fs::path(path).lexically_relative(folder.path()).string());
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a folder stands for its lists, machine files and programs, sorted") {
  axisc::test::TemporaryFolder const folder;
  for (auto const* const name : {"b.lis", "A.LIS", "sub/c.lis", "notes.txt", "part.nc"})
    folder.write(name, "");
  folder.write("other.json", R"({"no": "axes"})");
  folder.write("machine.json", R"({"axes": []})");
  folder.write("broken.json", R"({"axes": [)");
  auto const inputs = expand_inputs({folder.path()});
  CHECK(names(folder, inputs.paths) ==
        Names{"A.LIS", "b.lis", "broken.json", "machine.json", "part.nc", "sub/c.lis"});
  CHECK(inputs.failures.empty());
}

TEST_CASE("a list is checked once, through its machine file") {
  axisc::test::TemporaryFolder const folder;
  for (auto const* const name : {"x.lis", "y.lis", "default.lis", "alone.lis"}) folder.write(name, "");
  auto const machine = folder.write(
      "machine.json",
      R"({"default_list": "default.lis", "axes": [{"list": "x.lis"}, {"list": "sub/../y.lis"}]})");
  CHECK(names(folder, expand_inputs({folder.path()}).paths) == Names{"alone.lis", "machine.json"});
  CHECK(names(folder, expand_inputs({folder / "x.lis", machine, folder / "./machine.json"}).paths) ==
        Names{"machine.json"});
}

TEST_CASE("a program is checked once, through the machine file that names it") {
  axisc::test::TemporaryFolder const folder;
  for (auto const* const name : {"x.lis", "a.nc", "b.nc", "alone.nc"}) folder.write(name, "");
  folder.write("machine.json", R"({"axes": [{"list": "x.lis"}], "programs": ["a.nc", 1],
                                   "groups": [{"programs": ["sub/../b.nc"]}, 2, {"programs": {}}]})");
  CHECK(names(folder, expand_inputs({folder.path()}).paths) == Names{"alone.nc", "machine.json"});
}

TEST_CASE("names that cannot be used are reported, the others are kept") {
  axisc::test::TemporaryFolder const folder;
  fs::create_directories(folder / "empty");
  auto const inputs = expand_inputs({folder / "part.NC", folder / "empty", folder / "missing.lis"});
  CHECK(names(folder, inputs.paths) == Names{"part.NC", "missing.lis"});
  REQUIRE(inputs.failures.size() == 1);
  CHECK_THAT(inputs.failures[0].what(), Catch::Matchers::Contains("holds no list"));
}

TEST_CASE("links that run in a circle end") {
  axisc::test::TemporaryFolder const folder;
  folder.write("x.lis", "");
  fs::create_directory_symlink(".", folder / "again");
  CHECK(names(folder, expand_inputs({folder.path()}).paths) == Names{"x.lis"});
}

TEST_CASE("the outline of a machine file") {
  CHECK_FALSE(read_machine_outline("[1]").is_machine);
  CHECK_FALSE(read_machine_outline("{\"a\": {\"axes\": 1}}").is_machine);
  CHECK_FALSE(read_machine_outline("no json").is_machine);
  auto const odd = read_machine_outline(R"({"axes": [1, {"list": 2}, "x"], "cycle_time_us": 1})");
  CHECK(odd.is_machine);
  CHECK(odd.named.empty());
}
