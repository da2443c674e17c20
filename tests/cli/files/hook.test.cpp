// Hooks name all files of a commit: those that the program itself would find are checked, and no name is a
// response file.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <regex>

namespace hook_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

/// The entry and the pattern of a hook, as pre-commit reads them.
struct Hook {
  std::vector<std::string> words;
  std::regex files;
};

Hook hook_named(std::string const& id) {
  std::ifstream file(AXISC_SOURCE_DIR "/.pre-commit-hooks.yaml");
  Hook hook;
  bool is_it = false;
  for (std::string line; std::getline(file, line);) {
    auto const value_of = [&](std::string const& key) {
      auto const at = line.find(key + ": ");
      return at == std::string::npos ? std::string() : line.substr(at + key.size() + 2);
    };
    if (line.starts_with("- id: ")) is_it = value_of("id") == id;
    if (!is_it) continue;
    if (auto const entry = value_of("entry"); !entry.empty()) {
      std::istringstream words(entry);
      std::string program;
      words >> program;
      CHECK(program == "axisc");
      for (std::string word; words >> word;) hook.words.push_back(word);
    }
    if (auto const pattern = value_of("files"); !pattern.empty()) {
      std::string const ignoring_case = "(?i)";
      REQUIRE(pattern.starts_with(ignoring_case));
      hook.files = std::regex(pattern.substr(ignoring_case.size()), std::regex::icase);
    }
  }
  REQUIRE_FALSE(hook.words.empty());
  return hook;
}

/// As pre-commit calls the hook: with the files of a commit that the pattern takes.
Outcome run_hook(Hook const& hook, std::vector<std::string> const& arguments, TemporaryFolder const& folder,
                 std::vector<std::string> const& committed) {
  auto words = hook.words;
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (auto const& name : committed) {
    if (std::regex_search(name, hook.files)) words.push_back(name);
  }
  return run_axisc(words, in_folder(folder.path()));
}

std::string const broken = "filter[0].order 1,5x\n";

}  // namespace

TEST_CASE("the hook takes all names that a folder is searched for") {
  auto const lint = hook_named("axisc-lint");
  for (std::string const name : {"x.lis", "X.LIS", "a/A.NC", "m.tsproj", "A 1.Xti", "listen/hochlauf.xml",
                                 "axisc.json", "machine.json", "a/mill.json", "@x.lis"}) {
    INFO(name);
    CHECK(std::regex_search(name, lint.files));
  }
  for (std::string const name : {"x.lis.txt", "lis", "README.md", "x.jsonc", "xml"}) {
    INFO(name);
    CHECK_FALSE(std::regex_search(name, lint.files));
  }
  auto const fmt = hook_named("axisc-fmt");
  CHECK(std::regex_search(std::string("X.LIS"), fmt.files));
  CHECK_FALSE(std::regex_search(std::string("x.xml"), fmt.files));
}

TEST_CASE("each file of a commit that is a list, a machine or a program is checked, others are passed over") {
  TemporaryFolder const folder;
  folder.write("X.LIS", broken);
  folder.write("A.NC", "#FILTER ON [ORDER=999]\n");
  folder.write("update.xml", "<AX_MDS><P-AXIS-00140 value=\"1\"/></AX_MDS>");
  folder.write("pom.xml", "<project/>");
  folder.write("mill.json", R"({"axes": [{"name": "X", "list": "gone.lis"}]})");
  folder.write("package.json", R"({"name": "x"})");
  folder.write("p.tsproj", "<TcSmItem><Ax");
  folder.write("plc.tsproj", "<TcSmItem/>");
  folder.write("axisc.json", R"({"exclude": ["old.lis"]})");
  folder.write("old.lis", broken);
  std::vector<std::string> const all{"A.NC",      "X.LIS",        "axisc.json",  "mill.json", "old.lis",
                                     "p.tsproj",  "package.json", "plc.tsproj",  "pom.xml",   "update.xml",
                                     "README.md", "@x.lis",       "machine.json"};
  folder.write("@x.lis", "filter[1].order 2,5x\n");
  folder.write("x.lis", "filter[0].enable 0\n");
  folder.write("machine.json", "");
  auto const outcome = run_hook(hook_named("axisc-lint"), {"--cycle-time", "1ms"}, folder, all);
  CHECK(outcome.status == 1);
  for (std::string const told :
       {"A.NC:1", "X.LIS:1", "mill.json:1", "p.tsproj:1", "update.xml:1", "@x.lis:1", "machine.json:1"}) {
    CHECK_THAT(outcome.out, Contains("--> " + told));
  }
  CHECK_THAT(outcome.out, !Contains("package.json") && !Contains("pom.xml") && !Contains("plc.tsproj") &&
                              !Contains("axisc.json") && !Contains("old.lis"));
  auto const nothing =
      run_hook(hook_named("axisc-lint"), {}, folder, {"package.json", "pom.xml", "axisc.json"});
  CHECK(nothing.status == 0);
  folder.write("axisc.json", "{");
  CHECK(run_hook(hook_named("axisc-lint"), {}, folder, {"axisc.json"}).status == 2);
}

TEST_CASE("a list that begins with @ is a file for hooks and after --") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("@x.lis", "filter[1].order 2,5x\n");
  folder.write("x.lis", "ok.lis\n");
  folder.write("ok.lis", "filter[0].enable 0\n");
  for (std::vector<std::string> const& words :
       {std::vector<std::string>{"lint", "--cycle-time", "1ms", "--", "@x.lis"},
        {"lint", "--cycle-time", "1ms", "--", "ok.lis", "@x.lis"},
        {"lint", "--hook", "@x.lis"}}) {
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.out, Contains("@x.lis:1:17"));
  }
  CHECK(run_axisc({"lint", "@x.lis", "--cycle-time", "1ms"}, there).status == 0);
  folder.write("@y.lis", "kopf.achs_nr   1\nkopf.log_achs_name X\n");
  for (std::vector<std::string> const& words :
       {std::vector<std::string>{"fmt", "--check", "--", "@y.lis"}, {"fmt", "--hook", "--check", "@y.lis"}}) {
    CHECK(run_axisc(words, there).status == 1);
  }
  CHECK(run_axisc({"compile", "--cycle-time", "1ms", "-o", "y.axim", "--", "@y.lis"}, there).status == 0);
}

}  // namespace hook_test
