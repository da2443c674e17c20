#include "axisc/workspace/workspace.hpp"

#include "axisc/checking/check_input.hpp"
#include "diagnostics/location.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"

#include <map>
#include <string>
#include <vector>

using namespace axisc;

namespace {

char const* const machine_file = R"({"cycle_time_us": 2000, "axes": [{"name": "X", "list": "x.lis"}]})";
char const* const good = "kopf.achs_nr 1\nkenngr.achs_typ 1\n";
char const* const zero = "kopf.achs_nr 01\nkenngr.achs_typ 1\n";

std::vector<std::string> codes(CheckedInput const& checked) {
  std::vector<std::string> codes;
  for (auto const& finding : checked.findings) codes.push_back(code_text(finding.code));
  return codes;
}

}  // namespace

TEST_CASE("unsaved text takes the place of a file until it is dropped") {
  tests::MapFiles files(std::map<std::string, std::string>{{"x.lis", good}});
  Workspace workspace(files, {.quiet = true});
  CHECK(codes(check_input(workspace, "x.lis", nullptr)).empty());
  workspace.put("x.lis", zero);
  CHECK(codes(check_input(workspace, "x.lis", nullptr)) == std::vector<std::string>{"AX1006"});
  CHECK(codes(check_input(workspace, "./x.lis", nullptr)) == std::vector<std::string>{"AX1006"});
  workspace.drop("x.lis");
  CHECK(codes(check_input(workspace, "x.lis", nullptr)).empty());
}

TEST_CASE("unsaved text may be a file that does not exist") {
  tests::MapFiles files(std::map<std::string, std::string>{});
  Workspace workspace(files);
  CHECK(check_input(workspace, "x.lis", nullptr).failure);
  workspace.put("x.lis", good);
  CHECK_FALSE(check_input(workspace, "x.lis", nullptr).failure);
  CHECK(workspace.files().is_file("x.lis"));
  CHECK(workspace.files().names_in("") == std::vector<std::string>{"x.lis"});
}

TEST_CASE("of a list in its machine only what concerns the list is shown") {
  tests::MapFiles files({{"x.lis", zero}, {"y.lis", zero}});
  Workspace workspace(files, {.quiet = true});
  workspace.put("machine.json", R"({"cycle_time_us": 2000, "axes": [{"name": "X", "list": "x.lis"},
                                    {"name": "Y", "list": "y.lis"}]})");
  Inputs inputs;
  inputs.paths = {"y.lis"};
  workspace.judge_in_machines(inputs);
  auto const checked = check_input(workspace, inputs.paths.front(), nullptr);
  for (auto const& finding : checked.findings) CHECK(file_of(finding, checked.sources) == "y.lis");
  CHECK_FALSE(checked.findings.empty());
  CHECK(checked.elsewhere.errors + checked.elsewhere.warnings > 0);
}

TEST_CASE("a cycle time for lists that say none gives way to that of a machine") {
  tests::MapFiles files({{"machine.json", machine_file}, {"x.lis", good}});
  Overrides overrides;
  overrides.options.cycle_time_otherwise = design::CycleTime{4'000'000};
  Workspace workspace(files, overrides);
  CheckedInput checked;
  auto const judged = judge_input(workspace, "machine.json", checked, [](Finding&&, SourceSet const&) {});
  REQUIRE(judged.result.machine);
  CHECK(judged.result.machine->cycle_time.microseconds() == 2000);
  auto const alone = judge_input(workspace, "x.lis", checked, [](Finding&&, SourceSet const&) {});
  REQUIRE(alone.result.machine);
  CHECK(alone.result.machine->cycle_time.microseconds() == 4000);
}
