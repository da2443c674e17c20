#include "axisc/workspace/inputs.hpp"

#include "axisc/workspace/machine_outline.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

using namespace axisc;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names(axisc::test::TemporaryFolder const& folder,
                               std::vector<std::string> const& paths) {
  std::vector<std::string> result;
  result.reserve(paths.size());
  for (auto const& path : paths) result.push_back(fs::path(path).lexically_relative(folder.path()).string());
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a folder stands for its lists, machine files and programs, sorted") {
  axisc::test::TemporaryFolder const folder;
  for (auto const* const name : {"b.lis", "A.LIS", "sub/c.lis", "notes.txt", "part.nc"}) {
    folder.write(name, "");
  }
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

TEST_CASE("a machine file is always checked itself, whoever names it") {
  axisc::test::TemporaryFolder const folder;
  folder.write("x.lis", "");
  auto const prod = folder.write("prod.json", R"({"axes": [{"list": "x.lis"}]})");
  auto const test = folder.write(
      "test.json",
      R"({"axes": [{"list": "prod.json"}], "default_list": "test.json", "programs": ["prod.json"]})");
  CHECK(names(folder, expand_inputs({folder.path()}).paths) == Names{"prod.json", "test.json"});
  CHECK(names(folder, expand_inputs({test, prod}).paths) == Names{"test.json", "prod.json"});
  CHECK(names(folder, expand_inputs({test}).paths) == Names{"test.json"});
}

TEST_CASE("a list that is named as a program is still checked as a list") {
  axisc::test::TemporaryFolder const folder;
  for (auto const* const name : {"x.lis", "y.lis", "a.nc"}) folder.write(name, "");
  folder.write("m.json", R"({"axes": [{"list": "x.lis"}, {"list": "a.nc"}], "programs": ["y.lis"]})");
  CHECK(names(folder, expand_inputs({folder.path()}).paths) == Names{"a.nc", "m.json", "y.lis"});
}

TEST_CASE("what may be read is known before anything is written") {
  axisc::test::TemporaryFolder const folder;
  auto const machine = folder.write("m.json", R"({"axes": [{"list": "x.lis"}], "programs": ["a.nc"]})");
  auto const names_file = folder.write("names.txt", machine + "\n");
  auto const inputs = expand_inputs({"@" + names_file});
  CHECK(names(folder, inputs.sources) == Names{"x.lis", "a.nc", "m.json", "names.txt"});
  CHECK(names(folder, inputs.named) == Names{"m.json"});
}

TEST_CASE("a folder below that cannot be read is named itself, the others are read") {
  axisc::test::TemporaryFolder const folder;
  folder.write("p/ok/x.lis", "");
  folder.write("p/closed/y.lis", "");
  fs::permissions(folder.path(), static_cast<fs::perms>(0755));
  fs::permissions(folder / "p/closed", fs::perms::none);
  pid_t const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    // Who may read everything would see nothing of it.
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(2);
    auto const inputs = expand_inputs({folder / "p"});
    bool const is_right = inputs.paths.size() == 1 && inputs.failures.size() == 1 &&
                          std::string_view(inputs.failures[0].what()).find("p/closed: permission denied") !=
                              std::string_view::npos;
    ::_exit(is_right ? 0 : 1);
  }
  int status = -1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  fs::permissions(folder / "p/closed", fs::perms::owner_all);
  CHECK(status == 0);
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
  CHECK(odd.lists.empty());
  CHECK(odd.programs.empty());
}
