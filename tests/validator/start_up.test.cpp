// A start-up list becomes the machine that the control would build.
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"
#include "validator/loading/loading.hpp"

#include <deque>

namespace {

using namespace axisc;
using Contents = std::map<std::string, std::string>;

Contents controller() {
  return {{"hochlauf.lis",
           "kanal_anzahl 2\nsda_mds[0] sda1.lis\nsda_mds[1] sda2.lis\nzahl_mds 3\nachs_mds[0] "
           "x.lis\nachs_mds[1] y.lis\n"
           "achs_mds[2] s.lis\nachs_mds[3] ignored.lis\ndefault_achs_mds default.lis\nrtconf_lis rt.lis\n"
           "scheduling_position_controller OPT_CNC_POS_CONTROL\n"},
          {"rt.lis", "cycle_time 2000\n"},
          {"sda1.lis",
           "gruppe[0].bezeichnung Mill\ngruppe[0].achse[0].bezeichnung X\ngruppe[0].achse[0].log_achs_nr 1\n"
           "spindel[0].bezeichnung S1\nspindel[0].log_achs_nr 6\nstart_init_prog_file init.nc\n"
           "final_prog_file missing.nc\n"},
          {"sda2.lis", "gruppe[0].achse[0].log_achs_nr 2\n"},
          {"default.lis", "getriebe[0].dynamik.vb_max 500000\n"},
          {"x.lis", "kopf.achs_nr 1\nkopf.log_achs_name X_Achse\n"},
          {"y.lis", "kopf.achs_nr 2\nkopf.log_achs_name Y_Achse\n"},
          {"s.lis", "kopf.achs_nr 6\nkenngr.achs_typ 4\n"},
          {"init.nc", "#FILTER ON [ORDER=10]\n"}};
}

validator::LoadedMachine loaded(Contents contents, validator::CheckOptions const& options = {}) {
  tests::MapFiles files(std::move(contents));
  static std::deque<SourceSet> sources;
  return std::get<validator::LoadedMachine>(
      validator::load(files, "hochlauf.lis", options, sources.emplace_back()));
}

}  // namespace

TEST_CASE("axes, names, channels, cycle time and programs come from the lists that a start-up list names") {
  validator::LoadedMachine const machine = loaded(controller());
  REQUIRE(machine.axes.size() == 3);
  CHECK(machine.axes[0].name == "X");
  CHECK(machine.axes[1].name == "Y_Achse");
  CHECK(machine.axes[2].name == "S1");
  CHECK(machine.axes[2].type == machine::AxisType::spindle);
  CHECK(machine.axes[0].position_control == machine::PositionController::cnc);
  CHECK(machine.axes[0].merged.values.at("getriebe[].dynamik.vb_max", 0).value.number == 500000);
  CHECK(machine.cycle_time->nanoseconds == 2'000'000);
  REQUIRE(machine.groups.size() == 2);
  CHECK(machine.groups[0].name == "Mill");
  CHECK(machine.groups[0].axes == std::vector<std::size_t>{0});
  CHECK(machine.groups[1].axes == std::vector<std::size_t>{1});
  REQUIRE(machine.groups[0].programs.size() == 1);
  CHECK(machine.programs[machine.groups[0].programs[0]].name == "init.nc");
  CHECK(machine.groups[1].programs.empty());
  CHECK(machine.complete);
}

TEST_CASE("the command line's cycle time wins over the real-time list") {
  validator::CheckOptions options;
  options.cycle_time = design::CycleTime{1'000'000};
  CHECK(loaded(controller(), options).cycle_time->nanoseconds == 1'000'000);
}

TEST_CASE("two axes never have one name") {
  Contents contents = controller();
  contents["s.lis"] = "kopf.achs_nr 1\n";
  validator::LoadedMachine const machine = loaded(std::move(contents));
  CHECK(machine.axes[0].name == "X");
  CHECK(machine.axes[2].name == "X_2");
}

TEST_CASE("a missing list does not keep the others from being checked") {
  Contents contents = controller();
  contents.erase("y.lis");
  contents["x.lis"] += "filter[0].order 99\nfilter[0].enable 1\n";
  tests::MapFiles files(std::move(contents));
  SourceSet sources;
  auto const result = validator::check(files, "hochlauf.lis", {}, sources);
  std::vector<std::string> codes;
  for (Finding const& finding : result.findings) codes.push_back(code_text(finding.code));
  CHECK(std::count(codes.begin(), codes.end(), "AX7002") == 1);
  CHECK(std::count(codes.begin(), codes.end(), "AX3001") == 1);
  CHECK_FALSE(result.machine.has_value());
}

TEST_CASE("a start-up list that names itself is neither an axis nor a channel") {
  Contents contents = controller();
  contents["hochlauf.lis"] += "achs_mds[1] hochlauf.lis\nsda_mds[1] hochlauf.lis\n";
  validator::LoadedMachine const machine = loaded(std::move(contents));
  CHECK(machine.axes.size() == 2);
  CHECK(machine.groups.size() == 1);
  CHECK_FALSE(machine.complete);
}

TEST_CASE("a list beside the start-up list is taken, and only --pedantic says so") {
  Contents contents = controller();
  contents["hochlauf.lis"] += "achs_mds[0] lists/x.lis\n";
  for (bool const pedantic : {false, true}) {
    validator::CheckOptions options;
    options.pedantic = pedantic;
    tests::MapFiles files(contents);
    SourceSet sources;
    auto const result = validator::check(files, "hochlauf.lis", options, sources);
    auto const is_note = [](Finding const& finding) {
      return code_text(finding.code) == "AX7002" && finding.severity == Severity::note;
    };
    CHECK(std::count_if(result.findings.begin(), result.findings.end(), is_note) == (pedantic ? 1 : 0));
    CHECK(result.machine.has_value());
  }
}

TEST_CASE("a comment in a channel list or a start-up list silences a finding there") {
  Contents contents = controller();
  contents["sda2.lis"] = "gruppe[0].achse[0].log_achs_nr 1 ( axisc: allow AX7010\n";
  contents["hochlauf.lis"] += "achs_mds[9] more.lis ( axisc: allow list-ignored\n";
  tests::MapFiles files(contents);
  SourceSet sources;
  auto const result = validator::check(files, "hochlauf.lis", {}, sources);
  std::string codes;
  for (Finding const& finding : result.findings) codes += code_text(finding.code) + " ";
  // achs_mds[3] has no such comment; the program switches on a filter that the lists do not have.
  CHECK(codes == "AX7003 AX5006 ");
}

TEST_CASE("a list that is there and cannot be read is told with the reason") {
  Contents contents = controller();
  contents["x.lis"] = std::string(64, '\1');
  contents["rt.lis"] = std::string(
      "\xFF\xFE"
      "c\0y\0",
      6);
  tests::MapFiles files(std::move(contents));
  SourceSet sources;
  auto const checked = validator::check(files, "hochlauf.lis", {}, sources);
  std::vector<std::string> messages;
  for (Finding const& finding : checked.findings) {
    if (code_text(finding.code) == "AX7002") messages.push_back(render(finding.message, Language::english));
  }
  CHECK(messages ==
        std::vector<std::string>{"the file \"x.lis\" is not a text file",
                                 "the file \"rt.lis\" is UTF-16; lists are UTF-8 or windows-1252"});
}
