#include "cli/glob.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>

using namespace axisc::test;

namespace {

/// Codes with their severities, in output order.
std::vector<std::string> codes(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "lint");
  arguments.insert(arguments.end(), {"--format", "json"});
  auto const outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  std::vector<std::string> result;
  auto const report = nlohmann::json::parse(outcome.out);
  for (auto const& finding : report["diagnostics"]) {
    result.push_back(finding["code"].get<std::string>() + " " + finding["severity"].get<std::string>());
  }
  return result;
}

std::string const slow_filter =
    "filter[0].enable 1\nfilter[0].type PT1\nfilter[0].order 1\nfilter[0].time_constant "
    "1500\nfilter_fir.order 2\nEnde\n";

}  // namespace

TEST_CASE("patterns for paths") {
  using axisc::cli::matches_glob;
  CHECK(matches_glob("*.lis", "x.lis"));
  CHECK_FALSE(matches_glob("*.lis", "old/x.lis"));
  CHECK(matches_glob("**/*.lis", "old/x.lis"));
  CHECK(matches_glob("**/*.lis", "x.lis"));
  CHECK(matches_glob("old/**", "old/a/b.lis"));
  CHECK_FALSE(matches_glob("old/**", "older/b.lis"));
  CHECK_FALSE(matches_glob("**/b.lis", "a/bb.lis"));
  CHECK(matches_glob("axis?.lis", "axis7.lis"));
  CHECK_FALSE(matches_glob("axis?.lis", "axis/.lis"));
  CHECK(matches_glob("", ""));
  CHECK_FALSE(matches_glob("", "x"));
}

TEST_CASE("the nearest axisc.json gives the cycle time, and the command line wins") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", slow_filter);
  CHECK(codes(there, {"x.lis"}) == std::vector<std::string>{"AX9006 note"});
  folder.write("axisc.json", R"({"cycle_time_us": 2000})");
  CHECK(codes(there, {"x.lis"}) == std::vector<std::string>{"AX3004 error"});
  CHECK(codes(there, {"x.lis", "--cycle-time", "1ms"}).empty());
}

TEST_CASE("codes are disabled everywhere or for a pattern, and severities changed") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("new.lis", "filter[0].guete 1,5\nunknown_name 1\n");
  folder.write("old.lis", "filter[0].guete 1,5\nunknown_name 1\n");
  folder.write(
      "axisc.json",
      R"({"severity": {"unknown-parameter": "note"}, "paths": [{"pattern": "old*", "disable": ["AX1005"]}]})");
  CHECK(codes(there, {"new.lis"}) == std::vector<std::string>{"AX1005 error", "AX2001 note"});
  CHECK(codes(there, {"old.lis"}) == std::vector<std::string>{"AX2001 note"});
  folder.write("axisc.json", R"({"disable": ["ax2001"], "severity": {"AX1005": "warning"}})");
  CHECK(codes(there, {"old.lis"}) == std::vector<std::string>{"AX1005 warning"});
  CHECK(run_axisc({"lint", "old.lis"}, there).status == 0);
}

TEST_CASE("the settings' language counts unless the command line names one") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter[0].guete 1,5\n");
  folder.write("axisc.json", R"({"language": "de"})");
  CHECK_THAT(run_axisc({"lint", "x.lis"}, there).out, Catch::Matchers::StartsWith("Fehler"));
  CHECK_THAT(run_axisc({"lint", "x.lis", "--lang", "en"}, there).out, Catch::Matchers::StartsWith("error"));
}

TEST_CASE("compile takes the cycle time from the settings") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "Ende\n");
  CHECK(run_axisc({"compile", "x.lis", "-o", "x.axim"}, there).status == 2);
  folder.write("axisc.json", R"({"cycle_time_us": 250})");
  CHECK(run_axisc({"compile", "x.lis", "-o", "x.axim"}, there).status == 0);
  CHECK_THAT(run_axisc({"inspect", "x.axim"}, there).out, Catch::Matchers::Contains("250 µs"));
}

TEST_CASE("what applies and where it comes from") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "Ende\n");
  folder.write("axisc.json", R"({"cycle_time_us": 250, "disable": ["AX4007"]})");
  auto const outcome = run_axisc({"lint", "x.lis", "--print-config", "--build", "V3.1.3080.00"}, there);
  CHECK(outcome.status == 0);
  CHECK(outcome.out ==
        "x.lis\n"
        "  cycle_time_us  250           axisc.json\n"
        "  build          V3.1.3080.00  command line\n"
        "  language       en            default\n"
        "  disable        AX4007        axisc.json\n");
}

TEST_CASE("settings that mean nothing are refused with their place") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "Ende\n");
  for (auto const& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"{\n  \"cycle_time\": 1\n}", "axisc.json:2:3: unknown key \"cycle_time\""},
           {R"({"cycle_time_us": 0})", "axisc.json:1:19: the cycle time"},
           {R"({"disable": ["AX1"]})", "there is no code \"AX1\""},
           {R"({"disable": "AX4007"})", "axisc.json:1:13: \"disable\" must be a list of texts"},
           {R"({"severity": {"AX4007": "fatal"}})", "\"AX4007\" must be one of error, warning, note"},
           {R"({"paths": [{"disable": []}]})", "axisc.json:1:12: the key \"pattern\" is missing here"},
           {R"({"build": "new"})", "is no build of the control"},
           {R"({"language": "fr"})", "\"language\" must be one of en, de"},
           {R"({"languag": "de"})",
            "unknown key \"languag\"; did you mean \"language\"?; keys here: cycle_time_us, "},
           {R"({"language": "de", "language": "en"})",
            "axisc.json:1:20: the key \"language\" stands here twice"},
           {"\xEF\xBB\xBF{\"language\": 1}", "axisc.json:1:14: \"language\" must be a text"},
           {"{", "no valid JSON"},
           {"[]", "an object in braces"}}) {
    folder.write("axisc.json", text);
    auto const outcome = run_axisc({"lint", "x.lis"}, there);
    INFO(text);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  }
}
