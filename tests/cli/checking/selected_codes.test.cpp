#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <set>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace selected_codes_test {

using namespace axisc::test;

namespace {

Surroundings const in_data = in_folder(AXISC_SOURCE_DIR "/tests/cli/data");

}  // namespace

TEST_CASE("codes are selected and left out by their beginning, and what fails a run can be said") {
  auto const lint = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"lint", "mistakes.lis", "--cycle-time", "1ms", "--format", "json"});
    auto const outcome = run_axisc(more, in_data);
    std::set<std::string> codes;
    auto const report = nlohmann::json::parse(outcome.out);
    for (auto const& finding : report["diagnostics"]) codes.insert(finding["code"].get<std::string>());
    return std::pair(outcome.status, codes);
  };
  auto const all = lint({}).second;
  std::set<std::string> of_text, others;
  for (auto const& code : all) (code.starts_with("AX1") ? of_text : others).insert(code);
  REQUIRE((!of_text.empty() && !others.empty()));
  CHECK(lint({"--select", "ax1*"}) == std::pair(1, of_text));
  CHECK(lint({"--disable", "AX1*"}).second == others);
  CHECK(lint({"--select", "AX1*", "--disable", *of_text.begin()}).second.size() == of_text.size() - 1);
  CHECK(lint({"--fail-on", "never"}) == std::pair(0, all));
  CHECK(run_axisc({"lint", "no.lis", "--fail-on", "never"}, in_data).status == 2);
  CHECK(run_axisc({"lint", "warning.lis", "--cycle-time", "1ms", "--fail-on", "warning"}, in_data).status ==
        1);
  CHECK(run_axisc({"lint", "warning.lis", "--select", "AXY*"}, in_data).status == 2);
  TemporaryFolder const folder;
  folder.write("x.lis", "filter_fir.type 1\nfilter_fir.order 300\n");
  folder.write("axisc.json", R"({"severity": {"AX3*": "note", "AX3001": "warning"}, "disable": ["AX9*"]})");
  auto const milder = run_axisc({"lint", "x.lis"}, in_folder(folder.path()));
  CHECK(milder.status == 0);
  CHECK_THAT(milder.out, Catch::Matchers::Contains("warning[AX3001]"));
}

}  // namespace selected_codes_test
