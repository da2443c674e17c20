#include "axisc/settings/glob.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

using namespace axisc::test;

namespace {

/// Codes with their severities, in output order.
std::vector<std::string> codes_in(std::string const& report) {
  std::vector<std::string> result;
  auto const json = nlohmann::json::parse(report);
  for (auto const& finding : json["diagnostics"]) {
    result.push_back(finding["code"].get<std::string>() + " " + finding["severity"].get<std::string>());
  }
  return result;
}

std::vector<std::string> codes(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "lint");
  arguments.insert(arguments.end(), {"--format", "json"});
  auto const outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  return codes_in(outcome.out);
}

/// What `lint` and `compile` have to say alike about an input.
struct Judgement {
  int status;
  std::vector<std::string> codes;
  friend bool operator==(Judgement const&, Judgement const&) = default;
};

Judgement lint(Surroundings const& there, std::string const& input) {
  auto const outcome = run_axisc({"lint", input, "--format", "json"}, there);
  return {.status = outcome.status, .codes = codes_in(outcome.out)};
}

Judgement compile(Surroundings const& there, std::string const& input) {
  auto const outcome = run_axisc({"compile", input, "-o", "out.axim", "--format", "json"}, there);
  INFO(outcome.err);
  return {.status = outcome.status, .codes = codes_in(outcome.err)};
}

bool is_written(TemporaryFolder const& folder) {
  return std::filesystem::exists(folder.path() + "/out.axim");
}

/// A machine of one axis, whose list and default list lie in different folders.
Surroundings machine_in_two_folders(TemporaryFolder const& folder) {
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "default_list": "base/default.lis",
      "axes": [{"name": "X", "list": "old/x.lis"}]})");
  folder.write("base/default.lis", "Ende\n");
  folder.write("old/x.lis", "Ende\n");
  return in_folder(folder.path());
}

/// AX3013 warns of it: a Butterworth low-pass of this order overshoots.
std::string const overshooting_filter =
    "filter[0].enable 1\nfilter[0].order 4\nfilter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 15\nEnde\n";

std::string const slow_filter =
    "filter[0].enable 1\nfilter[0].type PT1\nfilter[0].order 1\nfilter[0].time_constant "
    "1500\nfilter_fir.order 2\nEnde\n";

}  // namespace

TEST_CASE("patterns for paths") {
  using axisc::matches_glob;
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

TEST_CASE("lint and compile judge alike by the severities of the settings") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", overshooting_filter);
  folder.write("axisc.json", R"({"cycle_time_us": 1000})");
  Judgement const natural{.status = 0, .codes = {"AX3013 warning"}};
  CHECK(lint(there, "x.lis") == natural);
  CHECK(compile(there, "x.lis") == natural);
  REQUIRE(is_written(folder));
  std::filesystem::remove(folder / "out.axim");

  folder.write("axisc.json", R"({"cycle_time_us": 1000, "severity": {"AX3013": "error"}})");
  Judgement const raised{.status = 1, .codes = {"AX3013 error"}};
  CHECK(lint(there, "x.lis") == raised);
  CHECK(compile(there, "x.lis") == raised);
  CHECK_FALSE(is_written(folder));

  // A filter that is switched off has a quality that the control refuses; nothing of it is compiled.
  folder.write("x.lis", "filter[1].guete 0.5\nEnde\n");
  folder.write("axisc.json", R"({"cycle_time_us": 1000, "severity": {"AX2005": "warning"}})");
  Judgement const lowered{.status = 0, .codes = {"AX2005 warning"}};
  CHECK(lint(there, "x.lis") == lowered);
  CHECK(compile(there, "x.lis") == lowered);
  CHECK(is_written(folder));
}

TEST_CASE("a severity decides before it is decided which finding of a token stands") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  // Both AX3003 and AX2005 complain of a negative frequency, and AX3003 comes first among errors.
  folder.write("x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 -3\nEnde\n");
  folder.write("axisc.json", R"({"cycle_time_us": 1000})");
  CHECK(lint(there, "x.lis").codes == std::vector<std::string>{"AX3003 error"});
  folder.write("axisc.json", R"({"cycle_time_us": 1000, "severity": {"AX3003": "warning"}})");
  Judgement const demoted{.status = 1, .codes = {"AX2005 error"}};
  CHECK(lint(there, "x.lis") == demoted);
  CHECK(compile(there, "x.lis") == demoted);
}

TEST_CASE("a code disabled for a pattern hides no other finding, in lint and in compile") {
  TemporaryFolder const folder;
  auto const there = machine_in_two_folders(folder);
  folder.write("old/x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 -3\nEnde\n");
  folder.write("axisc.json", R"({"paths": [{"pattern": "old/**", "disable": ["AX3003"]}]})");
  Judgement const expected{.status = 1, .codes = {"AX2005 error"}};
  CHECK(lint(there, "m.json") == expected);
  CHECK(compile(there, "m.json") == expected);
  CHECK_FALSE(is_written(folder));
}

TEST_CASE("a pattern counts for the file of the finding, not for the input that leads to it") {
  TemporaryFolder const folder;
  auto const there = machine_in_two_folders(folder);
  folder.write("base/default.lis", "filter[1].guete 0.5\nEnde\n");
  folder.write("old/x.lis", "filter[2].guete 0.5 # axisc: allow AX2005\nEnde\n");
  for (std::string const pattern : {"*.json", "old/**"}) {
    folder.write("axisc.json", R"({"paths": [{"pattern": ")" + pattern + R"(", "disable": ["AX2005"]}]})");
    INFO(pattern);
    // The comment in old/x.lis is not blamed for what is not looked for there.
    Judgement const expected{.status = 1, .codes = {"AX2005 error"}};
    CHECK(lint(there, "m.json") == expected);
    CHECK(compile(there, "m.json") == expected);
  }
  folder.write("axisc.json", R"({"paths": [{"pattern": "base/*", "disable": ["AX2005"]}]})");
  Judgement const clean{.status = 0, .codes = {}};
  CHECK(lint(there, "m.json") == clean);
  CHECK(compile(there, "m.json") == clean);
}

TEST_CASE("a note that the settings call a warning needs no --pedantic") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter[0].order 2\nEnde\n");
  CHECK(codes(there, {"x.lis"}).empty());
  folder.write("axisc.json", R"({"cycle_time_us": 1000, "severity": {"AX3008": "warning"}})");
  Judgement const raised{.status = 0, .codes = {"AX3008 warning"}};
  CHECK(lint(there, "x.lis") == raised);
  CHECK(compile(there, "x.lis") == raised);
}

TEST_CASE("every command that makes a machine obeys the settings") {
  TemporaryFolder const folder;
  auto const there = machine_in_two_folders(folder);
  folder.write("old/x.lis", overshooting_filter);
  folder.write("part.nc", "N10 G01 X10 F1000\nN20 M30\n");
  std::vector<std::vector<std::string>> const commands = {
      {"diff", "m.json", "m.json"}, {"contour", "m.json"}, {"simulate", "m.json", "--program", "part.nc"}};
  for (auto const& command : commands) {
    INFO(command.front());
    folder.write("axisc.json", "{}");
    CHECK(run_axisc(command, there).status == 0);
    folder.write("axisc.json", R"({"severity": {"AX3013": "error"}})");
    auto const outcome = run_axisc(command, there);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("error[AX3013]"));
  }
}

TEST_CASE("what is silenced and cannot be compiled is left out by no command") {
  TemporaryFolder const folder;
  auto const there = machine_in_two_folders(folder);
  // Above half the sampling rate, which is 500 Hz.
  folder.write("old/x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 900\nEnde\n");
  folder.write("part.nc", "N10 G01 X10 F1000\nN20 M30\n");
  std::vector<std::vector<std::string>> const commands = {{"compile", "m.json", "-o", "out.axim"},
                                                          {"diff", "m.json", "m.json"},
                                                          {"contour", "m.json"},
                                                          {"simulate", "m.json", "--program", "part.nc"}};
  for (std::string const settings : {R"({"disable": ["AX3002"]})", R"({"severity": {"AX3002": "warning"}})",
                                     R"({"paths": [{"pattern": "old/*", "disable": ["AX3002"]}]})"}) {
    folder.write("axisc.json", settings);
    for (auto const& command : commands) {
      INFO(settings << " " << command.front());
      auto const outcome = run_axisc(command, there);
      CHECK(outcome.status == 2);
      CHECK_THAT(outcome.err, Catch::Matchers::Contains("cannot compile the filter `filter[0]`"));
    }
  }
  CHECK_FALSE(is_written(folder));
}

TEST_CASE("a machine of which a file is missing is never compiled, whatever is silenced") {
  TemporaryFolder const folder;
  auto const there = machine_in_two_folders(folder);
  std::filesystem::remove(folder / "old/x.lis");
  for (std::string const settings :
       {R"({"disable": ["AX4020"]})", R"({"severity": {"AX4020": "warning"}})"}) {
    folder.write("axisc.json", settings);
    auto const outcome = run_axisc({"compile", "m.json", "-o", "out.axim"}, there);
    INFO(settings);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("axisc: error: m.json"));
    CHECK_FALSE(is_written(folder));
  }
}

TEST_CASE("an NC program alone is refused in words by every command that needs a machine") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("part.nc", "N10 G01 X10 F1000\nN20 M30\n");
  std::vector<std::vector<std::string>> const commands = {
      {"compile", "part.nc", "-o", "out.axim"},
      {"diff", "part.nc", "part.nc"},
      {"contour", "part.nc"},
      {"simulate", "part.nc", "--program", "part.nc", "--cycle-time", "1ms"}};
  for (auto const& command : commands) {
    INFO(command.front());
    auto const outcome = run_axisc(command, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("part.nc is an NC program"));
  }
}

TEST_CASE("diff takes the cycle time from the settings") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("old.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\nEnde\n");
  folder.write("new.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 20\nEnde\n");
  folder.write("axisc.json", R"({"cycle_time_us": 250})");
  auto const by_settings = run_axisc({"diff", "old.lis", "new.lis"}, there).out;
  folder.write("axisc.json", "{}");
  CHECK(by_settings == run_axisc({"diff", "old.lis", "new.lis", "--cycle-time", "250us"}, there).out);
  CHECK(by_settings != run_axisc({"diff", "old.lis", "new.lis", "--cycle-time", "1ms"}, there).out);
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
           {R"({"build": "new"})", "is not a build of the control"},
           {R"({"language": "fr"})", "\"language\" must be one of en, de"},
           {R"({"languag": "de"})",
            "unknown key \"languag\"; did you mean \"language\"?; keys here: cycle_time_us, "},
           {R"({"language": "de", "language": "en"})",
            "axisc.json:1:20: the key \"language\" occurs here twice"},
           {"\xEF\xBB\xBF{\"language\": 1}", "axisc.json:1:14: \"language\" must be a text"},
           {"{", "not valid JSON"},
           {R"({"language": "de",})", "JSON has no comma after the last entry"},
           {"{\"language\": \"de\" // x\n}", "JSON has no comments"},
           {"{language: 1}", "texts and keys are in double quotes"},
           {R"({"language": "de" "build": "V3.1.3080.00"})", "a comma is missing before this"},
           {"[]", "an object in braces"}}) {
    folder.write("axisc.json", text);
    auto const outcome = run_axisc({"lint", "x.lis"}, there);
    INFO(text);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  }
}

TEST_CASE("readings of the motion are shown, and an unknown one is refused with those that there are") {
  TemporaryFolder const folder;
  folder.write("x.lis", "Ende\n");
  folder.write("axisc.json", R"({"motion": {"sine": "whole-change", "corner": "per-cycle"}})");
  auto const shown = run_axisc({"lint", "--print-config", "x.lis"}, in_folder(folder.path()));
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out,
             Catch::Matchers::Contains("motion: sine") && Catch::Matchers::Contains("whole-change"));
  CHECK_THAT(shown.out, !Catch::Matchers::Contains("motion: corner"));
  folder.write("axisc.json", R"({"motion": {"sine": "round"}})");
  auto const refused = run_axisc({"lint", "x.lis"}, in_folder(folder.path()));
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Matchers::Contains("axisc.json:1:21") &&
                              Catch::Matchers::Contains("ramps, whole-change, same-peak-jerk"));
  folder.write("axisc.json", R"({"motion": {"sinus": "ramps"}})");
  CHECK(run_axisc({"lint", "x.lis"}, in_folder(folder.path())).status == 2);
}
