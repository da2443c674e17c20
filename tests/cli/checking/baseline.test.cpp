#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace baseline_test {

using namespace axisc::test;

namespace {

std::string mistakes() {
  return read_source_file("tests/cli/data/mistakes.lis");
}

Outcome lint(TemporaryFolder const& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"lint", "x.lis", "--cycle-time", "1ms"});
  return run_axisc(arguments, in_folder(folder.path()));
}

}  // namespace

TEST_CASE("a baseline hides what it records, also when lines move") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  CHECK(lint(folder, {"--write-baseline", "known.json"}).status == 0);
  auto const hidden = lint(folder, {"--baseline", "known.json"});
  CHECK(hidden.status == 0);
  CHECK(hidden.out == "note: 3 findings are hidden by the baseline\n1 file: no findings\n");

  folder.write("x.lis", "# new\n\n" + mistakes());
  CHECK(lint(folder, {"--baseline", "known.json"}).status == 0);
  folder.write("x.lis", "kopf.mds_ident 1,5\n" + mistakes());
  auto const added = lint(folder, {"--baseline", "known.json"});
  CHECK(added.status == 1);
  CHECK_THAT(added.out, Catch::Matchers::Contains("x.lis:1:") && !Catch::Matchers::Contains("x.lis:6:"));
}

TEST_CASE("the baseline is sorted, one line per finding") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  REQUIRE(lint(folder, {"--write-baseline", "known.json"}).status == 0);
  check_golden("tests/cli/data/golden/baseline.json", folder.read("known.json"));
}

TEST_CASE("one identity in SARIF, GitLab report and baseline") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  REQUIRE(lint(folder, {"--write-baseline", "known.json"}).status == 0);
  std::string const sarif_text = lint(folder, {"--format", "sarif"}).out;
  CHECK(sarif_complaints(sarif_text) == std::vector<std::string>{});
  auto const sarif = nlohmann::json::parse(sarif_text)["runs"][0]["results"];
  auto const gitlab = nlohmann::json::parse(lint(folder, {"--format", "gitlab"}).out);
  std::string const baseline = folder.read("known.json");
  REQUIRE(sarif.size() == gitlab.size());
  for (std::size_t i = 0; i < sarif.size(); ++i) {
    auto const fingerprint = gitlab[i]["fingerprint"].get<std::string>();
    CHECK(sarif[i]["partialFingerprints"]["axiscIdentity/v2"] == fingerprint);
    CHECK_THAT(baseline, Catch::Matchers::Contains("\"" + fingerprint + "\""));
  }
}

namespace {

std::string list_with_frequency(std::string const& frequency) {
  return "kopf.achs_nr 1\nkopf.log_achs_name X\nfilter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 " +
         frequency + "\n";
}

Outcome lint_all(TemporaryFolder const& folder, std::string const& working_folder,
                 std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"lint", ".", "--cycle-time", "1ms"});
  return run_axisc(arguments, in_folder(folder / working_folder));
}

}  // namespace

TEST_CASE("a baseline never hides the same mistake in another machine") {
  TemporaryFolder const folder;
  folder.write("a/x.lis", list_with_frequency("600"));
  folder.write("b/x.lis", list_with_frequency("60"));
  REQUIRE(lint_all(folder, "", {"--write-baseline", "known.json"}).status == 0);
  folder.write("a/x.lis", list_with_frequency("60"));
  folder.write("b/x.lis", list_with_frequency("9999"));
  auto const outcome = lint_all(folder, "", {"--baseline", "known.json"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("b/x.lis:5:"));
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("holds AX3002 in a/x.lis X filter[0].fg_f0"));
}

TEST_CASE("the entries of a baseline follow a file that was renamed") {
  TemporaryFolder const folder;
  folder.write("a/x.lis", list_with_frequency("600"));
  folder.write("b/x.lis", list_with_frequency("60"));
  REQUIRE(lint_all(folder, "", {"--write-baseline", "known.json"}).status == 0);
  std::filesystem::rename(folder / "a", folder / "c");
  folder.write("b/x.lis", list_with_frequency("9999"));
  auto const outcome = lint_all(folder, "", {"--baseline", "known.json"});
  // One entry excuses one finding; the files are looked at in their order.
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("1 finding is hidden by the baseline"));
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("2 files: 1 error"));
}

TEST_CASE("a baseline names files as their repository does, wherever it is used from") {
  TemporaryFolder const folder;
  std::string marker;
  SECTION("the repository") {
    marker = ".git/HEAD";
  }
  SECTION("the settings") {
    marker = "axisc.json";
  }
  folder.write(marker, "{}");
  folder.write("axes/x.lis", list_with_frequency("600"));
  REQUIRE(lint_all(folder, "", {"--write-baseline", "known.json"}).status == 0);
  CHECK_THAT(folder.read("known.json"), Catch::Matchers::Contains(R"({"file": "axes/x.lis", "code")"));
  CHECK(lint_all(folder, "axes", {"--baseline", "../known.json"}).status == 0);
  auto const whole = lint_all(folder, "", {"--format", "gitlab"}).out;
  auto const part = lint_all(folder, "axes", {"--format", "gitlab"}).out;
  CHECK(nlohmann::json::parse(whole)[0]["fingerprint"] == nlohmann::json::parse(part)[0]["fingerprint"]);
}

TEST_CASE("a baseline's entries of files that a run does not read are not stale") {
  TemporaryFolder const folder;
  folder.write("a/x.lis", list_with_frequency("600"));
  folder.write("b/x.lis", list_with_frequency("600"));
  REQUIRE(lint_all(folder, "", {"--write-baseline", "known.json"}).status == 0);
  auto const outcome = run_axisc({"lint", "a/x.lis", "--cycle-time", "1ms", "--baseline", "known.json"},
                                 in_folder(folder.path()));
  CHECK(outcome.out == "note: 1 finding is hidden by the baseline\n1 file: no findings\n");
}

TEST_CASE("entries of the baseline that are not needed any more are named once") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  REQUIRE(lint(folder, {"--write-baseline", "known.json"}).status == 0);
  folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  auto const outcome = lint(folder, {"--baseline", "known.json"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains(
                 "note: the baseline holds AX3001 in x.lis x filter[1].order, which is not found"));
  CHECK(lines_of(outcome.out) == 4);
  CHECK(lines_of(lint(folder, {"--baseline", "known.json", "--disable", "AX3001"}).out) == 3);
  auto const json = nlohmann::json::parse(lint(folder, {"--baseline", "known.json", "--format", "json"}).out);
  CHECK(json["summary"]["baseline"]["hidden"] == 0);
  CHECK(json["summary"]["baseline"]["stale"].size() == 3);
}

TEST_CASE("a baseline that cannot be used is a clear failure") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  auto const refused = [&](std::string const& bytes, std::string const& expected) {
    folder.write("known.json", bytes);
    auto const outcome = lint(folder, {"--baseline", "known.json"});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  };
  refused("", "is not the JSON");
  refused("[]", "is not the JSON");
  refused(R"({"version": 3, "findings": []})", "\"version\" must be 2");
  refused(R"({"version": 1, "findings": []})", "write it anew with --write-baseline");
  refused(R"({"version": 2})", "\"findings\" is missing");
  refused(R"({"version": 2, "findings": [{"code": "AX3005"}]})", "entry 1");
  refused(
      R"({"version": 2, "findings": [{"file": "", "code": "3005", "axis": "", "parameter": "", "occurrence": 1}]})",
      "entry 1");
  refused(
      R"({"version": 2, "findings": [{"file": "", "code": "AX3005", "axis": "", "parameter": "", "occurrence": 0}]})",
      "entry 1");
  CHECK(lint(folder, {"--baseline", "missing.json"}).status == 2);
  CHECK(lint(folder, {"--write-baseline", "missing/known.json"}).status == 2);
  CHECK(lint(folder, {"--write-baseline", "./x.lis"}).status == 2);
  CHECK(folder.read("x.lis") == mistakes());
}

TEST_CASE("statistics count the findings of each code") {
  TemporaryFolder const folder;
  folder.write("x.lis", mistakes());
  auto const text = lint(folder, {"--statistics"});
  CHECK_THAT(text.out, Catch::Matchers::EndsWith("1  AX1005  decimal-comma\n"
                                                 "1  AX2001  unknown-parameter      1 with a fix\n"
                                                 "1  AX3001  filter-order-for-type  1 with a fix\n\n"
                                                 "1 file: 3 errors\n"));
  auto const json = nlohmann::json::parse(lint(folder, {"--statistics", "--format", "json"}).out);
  CHECK(json["statistics"].size() == 3);
  CHECK(json["statistics"][0]["code"] == "AX1005");
  CHECK(json["statistics"][0]["count"] == 1);
  CHECK(lint(folder, {"--statistics", "--format", "sarif"}).status == 2);
}

TEST_CASE("SARIF tells what was assumed as a notification of the tool") {
  TemporaryFolder const folder;
  folder.write("x.lis", list_with_frequency("600"));
  auto const there = in_folder(folder.path());
  auto const whole = run_axisc({"lint", "x.lis", "--format", "sarif"}, there).out;
  CHECK(sarif_complaints(whole) == std::vector<std::string>{});
  auto const run = nlohmann::json::parse(whole)["runs"][0];
  REQUIRE(run["results"].size() == 1);
  CHECK(run["results"][0]["ruleId"] == "AX3002");
  auto const& notice = run["invocations"][0]["toolExecutionNotifications"][0];
  CHECK(notice["associatedRule"]["id"] == "AX9006");
  CHECK(notice["level"] == "note");
}

}  // namespace baseline_test
