// Pipes, devices, links in a circle, files that change or are too large: one line each, and nothing waits.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace irregular_files_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string machine_of(std::string const& list) {
  return R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": ")" + list + R"("}]})";
}

std::string const crooked = "kenngr.achs_typ\t\t1 # x\nEnde\n";
std::string const fixable = "filter[0].fg_f0 1,5\nEnde\n";

}  // namespace

TEST_CASE("a list, a program and settings are regular files") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  REQUIRE(::mkfifo((folder / "pipe.lis").c_str(), 0600) == 0);
  REQUIRE(::mkfifo((folder / "pipe.nc").c_str(), 0600) == 0);
  folder.write("x.lis", "Ende\n");
  for (std::string const name : {"pipe.lis", "pipe.nc", "/dev/zero"}) {
    auto const outcome = run_axisc({"lint", name}, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("AX9001") && Contains("not a regular file"));
    CHECK(lines_of(outcome.err) == 1);
  }
  for (std::string const list : {"pipe.lis", "/dev/zero"}) {
    folder.write("m.json", machine_of(list));
    auto const outcome = run_axisc({"lint", "m.json"}, there);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.out, Contains("AX4020") && Contains("not a regular file"));
  }
  folder.write("m.json", machine_of("x.lis"));
  CHECK(run_axisc({"fmt", "pipe.lis"}, there).status == 2);
  CHECK(run_axisc({"simulate", "m.json", "--program", "pipe.nc"}, there).status == 2);
  CHECK(run_axisc({"lint", "x.lis", "--schema", "pipe.lis"}, there).status == 2);
}

TEST_CASE("files of the kernel are not read, by whatever name", "[posix]") {
  TemporaryFolder const folder;
  auto there = in_folder(folder.path());
  there.variables = {"SECRET=topsecret"};
  std::string const secret = "/proc/self/environ";
  std::string const setting = "/sys/kernel/mm/transparent_hugepage/enabled";
  fs::create_symlink(secret, folder / "link.lis");
  fs::create_symlink("/proc", folder / "away");
  for (std::string const& name : {secret, setting, std::string("link.lis"), std::string("away/self/environ"),
                                  std::string("/proc/self/cmdline")}) {
    if (!fs::exists(fs::path(name).is_absolute() ? name : folder / name)) continue;
    INFO(name);
    auto const named = run_axisc({"lint", name}, there);
    CHECK(named.status == 2);
    CHECK_THAT(named.err, Contains("AX9001") && Contains("/proc or /sys"));
    folder.write("m.json", machine_of(name));
    folder.write("start.lis", "zahl_mds 1\nachs_mds[0] " + name + "\nEnde\n");
    for (std::string const machine : {"m.json", "start.lis"}) {
      auto const outcome = run_axisc({"lint", machine}, there);
      CHECK(outcome.status != 0);
      CHECK_THAT(outcome.out + outcome.err, !Contains("topsecret") && !Contains("madvise"));
    }
  }
  folder.write("x.lis", "filter[0].enable 0\n");
  folder.write("m.json", machine_of("x.lis"));
  auto const simulated = run_axisc({"simulate", "m.json", "--program", secret}, there);
  CHECK(simulated.status == 2);
  CHECK_THAT(simulated.err, Contains("not a regular file"));
}

TEST_CASE("a folder names what it does not read: pipes, and links to folders elsewhere", "[posix]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("d/ok.lis", "filter[0].enable 0\n");
  folder.write("e/bad.lis", "filter[0].order 1,5x\n");
  fs::create_directory_symlink("../e", folder / "d/sub");
  fs::create_directory_symlink(".", folder / "d/again");
  REQUIRE(::mkfifo((folder / "d/x.lis").c_str(), 0600) == 0);
  REQUIRE(::mkfifo((folder / "d/other").c_str(), 0600) == 0);
  for (std::vector<std::string> const& words :
       {std::vector<std::string>{"lint", "d", "--cycle-time", "1ms"},
        {"compile", "d", "--output-folder", "o", "--cycle-time", "1ms"},
        {"fmt", "d"}}) {
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.err,
               Contains("axisc: note: d/x.lis is not read") && Contains("axisc: note: d/sub is not"));
    CHECK_THAT(outcome.err, !Contains("d/again") && !Contains("d/other"));
  }
  auto const german = run_axisc({"lint", "d", "--cycle-time", "1ms", "--lang", "de"}, there);
  CHECK_THAT(german.err, Contains("axisc: Hinweis: d/x.lis wird nicht gelesen"));
  CHECK(run_axisc({"lint", "d", "--cycle-time", "1ms", "--quiet"}, there).err.empty());
  folder.write("axisc.json", R"({"exclude": ["d/x.lis", "e/**"]})");
  CHECK(run_axisc({"lint", "d", "--cycle-time", "1ms"}, there).err.empty());
  fs::remove(folder / "axisc.json");
  fs::remove(folder / "d/ok.lis");
  auto const alone = run_axisc({"lint", "d"}, there);
  CHECK(alone.status == 2);
  CHECK_THAT(alone.err, Contains("holds no list") && Contains("d/x.lis is not read"));
}

TEST_CASE("links in a circle have their own sentence") {
  TemporaryFolder const folder;
  fs::create_symlink("b.lis", folder / "a.lis");
  fs::create_symlink("a.lis", folder / "b.lis");
  auto const outcome = run_axisc({"lint", "a.lis"}, in_folder(folder.path()));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("lead in a circle"));
}

TEST_CASE("--fix and fmt change only what is named or below a named folder", "[posix]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder / "work");
  for (std::string const& text : {crooked, fixable}) {
    folder.write("other.lis", text);
    folder.write("work/below/x.lis", text);
    folder.write("work/m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "below/x.lis"},
                                    {"name": "Y", "list": "../other.lis"}, {"name": "Z", "list": "link.lis"}]})");
    fs::remove(folder / "work/link.lis");
    fs::create_symlink("../other.lis", folder / "work/link.lis");
    bool const fixes = text == fixable;
    auto const change = [&](std::string const& input) {
      return fixes ? run_axisc({"lint", input, "--fix=all"}, there) : run_axisc({"fmt", input}, there);
    };
    auto const outcome = change("m.json");
    CHECK(outcome.status == (fixes ? 1 : 2));
    CHECK(folder.read("other.lis") == text);
    CHECK(folder.read("work/below/x.lis") != text);
    static_cast<void>(change("."));
    CHECK(folder.read("other.lis") == text);
    static_cast<void>(change("link.lis"));
    CHECK(folder.read("other.lis") != text);
  }
}

TEST_CASE("a limit on file sizes is an error like a full disk") {
  TemporaryFolder const folder;
  folder.write("x.lis", crooked);
  struct rlimit before {};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  struct rlimit const small{.rlim_cur = 16, .rlim_max = before.rlim_max};
  auto* const handled = ::signal(SIGXFSZ, SIG_DFL);
  pid_t const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (::chdir(folder.path().c_str()) != 0 || ::setrlimit(RLIMIT_FSIZE, &small) != 0) ::_exit(126);
    ::execl(AXISC_PROGRAM, AXISC_PROGRAM, "fmt", "x.lis", nullptr);
    ::_exit(127);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  static_cast<void>(::signal(SIGXFSZ, handled));
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(folder.read("x.lis") == crooked);
  CHECK(folder.entries() == 1);
}

}  // namespace irregular_files_test
