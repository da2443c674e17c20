// `axisc lint --changed-since`: what differs from a revision of git.
#include "axisc/files/disk_files.hpp"
#include "axisc/workspace/machine_outline.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "validator/check.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

namespace changed_since_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

constexpr auto wrong = "filter[0].type LOWPASS\nfilter[0].order 99\n";

bool has_git() {
  return std::system("git --version >/dev/null 2>&1") == 0;  // NOLINT(concurrency-mt-unsafe)
}

/// Machine a with a1.lis and a2.lis, machine b with b.lis, and alone.lis, all committed as `base`.
class Repository {
 public:
  Repository() {
    for (std::string const machine : {"a", "b"}) {
      write(
          machine + "/machine.json",
          R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "1.lis"}, {"name": "Y", "list": "2.lis"}]})");
      write(machine + "/1.lis", wrong);
      write(machine + "/2.lis", wrong);
    }
    write("alone.lis", wrong);
    write("other.txt", "");
    git("init -q .");
    commit();
    git("tag base");
  }

  void write(std::string const& name, std::string const& text) const { folder_.write(name, text); }
  void remove(std::string const& name) const { fs::remove(folder_ / name); }
  void link(std::string const& target, std::string const& name) const {
    fs::create_symlink(target, folder_ / name);
  }
  void git(std::string const& words) const {
    auto const command = "cd '" + folder_.path() +
                         "' && git -c user.name=x -c user.email=x@example.com -c init.defaultBranch=main "
                         "-c core.autocrlf=false " +
                         words + " >/dev/null 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe)
  }
  void commit() const {
    git("add -A");
    git("commit -q -m x");
  }

  [[nodiscard]] Outcome lint(std::vector<std::string> const& more = {"--changed-since", "base"},
                             std::string const& folder = "") const {
    std::vector<std::string> arguments{"lint"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto there = in_folder(folder.empty() ? folder_.path() : folder_ / folder);
    // Settings of whoever runs the tests do not matter.
    there.variables = {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_SYSTEM=/dev/null"};
    return run_axisc(arguments, there);
  }
  /// The files in which it finds something.
  [[nodiscard]] std::set<std::string> judged(std::string const& folder = "") const {
    auto const outcome = lint({"--changed-since", "base", "--format", "json"}, folder);
    INFO(outcome.err);
    REQUIRE(outcome.err.empty());
    auto const report = nlohmann::json::parse(outcome.out);
    std::set<std::string> files;
    for (auto const& finding : report["diagnostics"]) {
      if (finding["file"].is_string()) files.insert(finding["file"].get<std::string>());
    }
    return files;
  }

 private:
  TemporaryFolder folder_;
};

using Files = std::set<std::string>;

}  // namespace

TEST_CASE("of a repository only what differs from the revision is judged", "[posix]") {
  if (!has_git()) return;
  Repository const repository;
  CHECK(repository.judged().empty());
  auto const nothing = repository.lint();
  CHECK(nothing.status == 0);
  CHECK(nothing.out == "nothing to check: no input differs from base\n");
  repository.write("other.txt", "changed");
  CHECK(repository.judged().empty());
  SECTION("a list of no machine") {
    repository.write("alone.lis", std::string(wrong) + "# more\n");
    CHECK(repository.judged() == Files{"alone.lis"});
  }
  SECTION("a list of a machine, with the machine") {
    repository.write("a/1.lis", std::string(wrong) + "# more\n");
    CHECK(repository.judged() == Files{"a/1.lis", "a/2.lis"});
  }
  SECTION("a machine file") {
    repository.write(
        "b/machine.json",
        R"({"cycle_time_us": 2000, "axes": [{"name": "X", "list": "1.lis"}, {"name": "Y", "list": "2.lis"}]})");
    CHECK(repository.judged() == Files{"b/1.lis", "b/2.lis"});
  }
  SECTION("a list that git does not know yet") {
    repository.write("a/new ü\n.lis", wrong);
    CHECK(repository.judged() == Files{"a/new ü\n.lis"});
  }
  SECTION("a list that git ignores is no change") {
    repository.write(".gitignore", "built/\n");
    repository.write("built/x.lis", wrong);
    CHECK(repository.judged().empty());
  }
  SECTION("a new name") {
    repository.git("mv alone.lis renamed.lis");
    CHECK(repository.judged() == Files{"renamed.lis"});
  }
  SECTION("what is committed") {
    repository.write("alone.lis", std::string(wrong) + "# more\n");
    repository.commit();
    CHECK(repository.judged() == Files{"alone.lis"});
  }
  SECTION("settings concern everything below them") {
    repository.write("a/axisc.json", "{}");
    CHECK(repository.judged() == Files{"a/1.lis", "a/2.lis"});
    repository.commit();
    repository.git("tag -f base");
    repository.remove("a/axisc.json");
    CHECK(repository.judged() == Files{"a/1.lis", "a/2.lis"});
  }
  SECTION("a link whose target differs") {
    repository.link("../alone.lis", "b/link.lis");
    repository.commit();
    repository.git("tag -f base");
    repository.write("alone.lis", std::string(wrong) + "# more\n");
    auto const outcome = repository.lint({"b", "--changed-since", "base", "--format", "jsonl"});
    CHECK_THAT(outcome.out, Contains("b/link.lis"));
  }
}

TEST_CASE("a list that is gone shows in the machine that names it, and nowhere else", "[posix]") {
  if (!has_git()) return;
  Repository const repository;
  repository.remove("alone.lis");
  CHECK(repository.lint().status == 0);
  repository.remove("a/2.lis");
  auto const outcome = repository.lint();
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Contains("2.lis"));
  CHECK_THAT(outcome.out, !Contains("alone.lis"));
  CHECK(repository.judged().contains("a/machine.json"));
}

TEST_CASE("a list that is gone shows in the start-up list that names it", "[posix]") {
  if (!has_git()) return;
  Repository const repository;
  repository.write("sd/hochlauf.lis",
                   "zahl_mds 1\ndefault_achs_mds ./listen/d.lis\nachs_mds[0] ./listen/c.lis\n");
  repository.write("sd/listen/c.lis", wrong);
  repository.write("sd/listen/d.lis", "");
  repository.commit();
  repository.git("tag -f base");
  CHECK(repository.judged().empty());
  repository.remove("sd/listen/c.lis");
  CHECK(repository.lint().status == 1);
  CHECK(repository.judged().contains("sd/hochlauf.lis"));
}

TEST_CASE("--changed-since works in a sub-folder, which then is all that is judged", "[posix]") {
  if (!has_git()) return;
  Repository const repository;
  repository.write("a/1.lis", std::string(wrong) + "# more\n");
  repository.write("b/1.lis", std::string(wrong) + "# more\n");
  CHECK(repository.judged("a") == Files{"1.lis", "2.lis"});
  CHECK(repository.lint({"b", "--changed-since", "base", "--quiet"}).status == 1);
  auto const both = repository.lint({".", "../b", "--changed-since", "base", "--format", "jsonl"}, "a").out;
  CHECK_THAT(both, Contains(R"("file":"../b/1.lis")") && Contains(R"("file":"1.lis")"));
}

TEST_CASE("--changed-since says what is missing", "[posix]") {
  if (!has_git()) return;
  Repository const repository;
  auto const refuses = [&](std::vector<std::string> const& arguments, std::string const& reason) {
    auto const outcome = repository.lint(arguments);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Contains(reason));
  };
  refuses({"--changed-since", "nowhere"}, "git cannot compare with \"nowhere\": bad revision 'nowhere'");
  refuses({"--changed-since="}, "needs a value");
  refuses({"--changed-since=--output=stolen"}, "needs a revision of git");
  refuses({"-", "--changed-since", "base"}, "cannot be used with standard input");
  refuses({"--changed-since", "base", "--write-baseline", "known.json"},
          "cannot be used with --write-baseline");
  TemporaryFolder const elsewhere;
  auto const outside = elsewhere.write("x.lis", wrong);
  refuses({outside, "--changed-since", "base"}, "is not in the repository");
  auto const no_repository = run_axisc({"lint", "--changed-since", "base"}, in_folder(elsewhere.path()));
  CHECK(no_repository.status == 2);
  CHECK_THAT(no_repository.err, Contains("needs a git repository"));
}

TEST_CASE("without git --changed-since says so") {
  TemporaryFolder const folder;
  fs::create_directories(folder / ".git");
  folder.write("x.lis", wrong);
  auto there = in_folder(folder.path());
  there.variables = {"PATH=" + folder.path()};
  auto const outcome = run_axisc({"lint", "--changed-since", "main"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("needs the program git, which cannot be started"));
}

TEST_CASE("what a machine is made of is known without checking it") {
  std::size_t machines = 0;
  for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / "samples")) {
    auto const path = entry.path().string();
    if (!entry.is_regular_file()) continue;
    auto const outline = axisc::outline_of(path);
    if (!outline.is_machine) continue;
    ++machines;
    std::set<fs::path> known{fs::weakly_canonical(path)};
    for (auto const& parts : {outline.lists, outline.programs}) {
      for (auto const& part : parts) known.insert(fs::weakly_canonical(entry.path().parent_path() / part));
    }
    axisc::DiskFiles files;
    axisc::SourceSet sources;
    auto const result = axisc::validator::check(files, path, {}, sources);
    for (auto const& file : result.files) {
      INFO(path << " reads " << file);
      CHECK(known.contains(fs::weakly_canonical(file)));
    }
  }
  CHECK(machines > 5);
}

}  // namespace changed_since_test
