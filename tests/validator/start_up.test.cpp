// A start-up list becomes the machine that the control would build.
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "validator/check.hpp"
#include "validator/loading/loading.hpp"

#include <deque>

namespace start_up_test {

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
           "spindel[0].bezeichnung S1\nspindel[0].log_achs_nr 6\nstart_init_prog_file init.nc\n"},
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

std::string severity(Finding const& finding) {
  if (finding.severity == Severity::error) return "error";
  return finding.severity == Severity::warning ? "warning" : "note";
}

/// "file:line CODE severity" of each finding, notes too.
tests::Lines found(Contents contents) {
  validator::CheckOptions options;
  options.pedantic = true;
  tests::Checked const checked(std::move(contents), "hochlauf.lis", options);
  tests::Lines lines;
  for (Finding const& finding : checked.result.findings) {
    SourceText const& source = checked.sources[finding.place->source];
    lines.push_back(source.name() + ":" + std::to_string(source.position(finding.place->span.begin).line) +
                    " " + code_text(finding.code) + " " + severity(finding));
  }
  return lines;
}

bool contains(tests::Lines const& lines, std::string const& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
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

TEST_CASE(
    "a cycle time of the real-time list that no control runs with is an error there, and none is taken") {
  Contents contents = controller();
  contents["rt.lis"] = "cycle_time 2\n";
  CHECK(contains(found(contents), "rt.lis:1 AX4020 error"));
  CHECK_FALSE(loaded(contents).cycle_time);
  CHECK_FALSE(tests::Checked(contents, "hochlauf.lis").result.machine);
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

TEST_CASE("without its default list a machine is checked with the control's own defaults") {
  Contents contents = controller();
  contents["x.lis"] += "filter[0].order 99\nfilter[0].enable 1\n";
  contents["y.lis"] = "kopf.achs_nr 1\n";
  std::string const found_code = GENERATE("AX7002", "AX7009");
  if (found_code == "AX7002") contents.erase("default.lis");
  if (found_code == "AX7009") contents["default.lis"] = contents["sda1.lis"];
  auto const lines = found(contents);
  CHECK(contains(lines, "hochlauf.lis:9 " + found_code + " error"));
  CHECK(contains(lines, "x.lis:3 AX3001 error"));
  // Two axes of one number.
  CHECK(contains(lines, "y.lis:1 AX4015 error"));

  tests::Checked const checked(contents, "hochlauf.lis");
  CHECK(checked.result.obstacle == validator::Obstacle::incomplete);
  auto const missing =
      std::find_if(checked.result.findings.begin(), checked.result.findings.end(),
                   [&](Finding const& finding) { return code_text(finding.code) == found_code; });
  REQUIRE(missing != checked.result.findings.end());
  CHECK_THAT(render(missing->notes.back(), Language::english),
             Catch::Matchers::Contains("the control's own defaults count"));
}

TEST_CASE("a program that a channel names is an error where it is missing or cannot be read") {
  Contents contents = controller();
  SECTION("missing") {
    contents["sda2.lis"] += "final_prog_file end.nc\n";
    CHECK(contains(found(contents), "sda2.lis:2 AX7002 error"));
  }
  SECTION("in UTF-16") {
    contents["init.nc"] = std::string("\xFF\xFEN\0", 4);
    CHECK(contains(found(contents), "sda1.lis:6 AX7002 error"));
  }
  SECTION("named by the default list of all channels, once") {
    contents["hochlauf.lis"] += "default_sda_mds sda.lis\n";
    contents["sda.lis"] = "final_prog_file end.nc\nstart_init_prog_file other.nc\n";
    auto const lines = found(contents);
    CHECK(std::count(lines.begin(), lines.end(), "sda.lis:1 AX7002 error") == 1);
    // The second channel names none of its own.
    CHECK(std::count(lines.begin(), lines.end(), "sda.lis:2 AX7002 error") == 1);
  }
  validator::CheckOptions options;
  options.disabled = {Code{7002}};
  tests::Checked const unseen(contents, "hochlauf.lis", options);
  CHECK_FALSE(unseen.result.machine);
  CHECK(unseen.result.obstacle == validator::Obstacle::incomplete);
}

TEST_CASE("of a parameter that names a program twice the last line counts") {
  Contents contents = controller();
  contents["sda1.lis"] += "m6_prog_file gone.nc\nM6_prog_file init.nc\n";
  CHECK(loaded(contents).complete);
}

TEST_CASE("streaming needs no file, and a note says that its lines are not checked") {
  Contents contents = controller();
  contents["sda1.lis"] += "streaming_prog_file stream.nc\n";
  CHECK(contains(found(contents), "sda1.lis:7 AX7002 note"));
  CHECK(loaded(contents).complete);
}

TEST_CASE("an axis list without any text is a warning, one that sets nothing is not") {
  Contents contents = controller();
  contents["y.lis"] = " \r\n\n";
  CHECK(contains(found(contents), "y.lis:1 AX7001 warning"));
  contents["y.lis"] = "# kopf.achs_nr 2\n";
  CHECK_FALSE(contains(found(contents), "y.lis:1 AX7001 warning"));
  contents["default.lis"] = "";
  CHECK(contains(found(contents), "default.lis:1 AX7001 warning"));
}

TEST_CASE("a count above the lists that are named is an error, no axis at all is another") {
  Contents contents = controller();
  SECTION("an axis") {
    contents["hochlauf.lis"] += "zahl_mds 5\n";
    CHECK(contains(found(contents), "hochlauf.lis:12 AX7002 error"));
  }
  SECTION("a compensation") {
    contents["hochlauf.lis"] += "zahl_kw 1\n";
    CHECK(contains(found(contents), "hochlauf.lis:12 AX7002 error"));
  }
  SECTION("a channel") {
    contents["hochlauf.lis"] += "kanal_anzahl 3\n";
    CHECK(contains(found(contents), "hochlauf.lis:12 AX7002 error"));
  }
  SECTION("no axis") {
    contents["hochlauf.lis"] += "zahl_mds 0\n";
    CHECK(contains(found(contents), "hochlauf.lis:12 AX7007 error"));
  }
  CHECK_FALSE(tests::Checked(contents, "hochlauf.lis").result.machine);
}

TEST_CASE("channel lists of which the control reads none are an error, and no channel is made up") {
  Contents contents = controller();
  std::string& start_up = contents["hochlauf.lis"];
  std::string const count = GENERATE("", "kanal_anzahl 0\n");
  start_up.replace(0, start_up.find('\n') + 1, count);
  auto const lines = found(contents);
  std::string const first = count.empty() ? "1" : "2";
  CHECK(contains(lines, "hochlauf.lis:" + first + " AX7003 error"));
  CHECK(loaded(contents).groups.empty());
  CHECK_FALSE(tests::Checked(contents, "hochlauf.lis").result.machine);
  // Without channel lists the axes are checked as one channel.
  start_up.erase(count.size(), start_up.find("zahl_mds") - count.size());
  CHECK(loaded(contents).groups.size() == 1);
}

TEST_CASE("AX7010: an axis or a name twice in one channel is an error, and allowed in two") {
  Contents contents = controller();
  contents["sda1.lis"] += "gruppe[0].achse[1].bezeichnung X2\ngruppe[0].achse[1].log_achs_nr 1\n";
  CHECK(contains(found(contents), "sda1.lis:8 AX7010 error"));
  contents["sda1.lis"] += "gruppe[0].achse[1].bezeichnung X\ngruppe[0].achse[1].log_achs_nr 2\n";
  auto const lines = found(contents);
  CHECK(contains(lines, "sda1.lis:9 AX7010 error"));
  CHECK(contains(lines, "sda2.lis:1 AX7010 warning"));
}

TEST_CASE("AX4014: a gantry of the lists that a start-up list names") {
  Contents contents = controller();
  contents["y.lis"] += "kenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 1\n";
  SECTION("without a fault") {
    contents["x.lis"] += "kenngr.achs_mode 0x10001\n";
    CHECK_FALSE(contains(found(contents), "y.lis:4 AX4014 error"));
  }
  SECTION("the master bit is missing") {
    contents["x.lis"] += "kenngr.achs_mode 0x1\n";
    CHECK(contains(found(contents), "y.lis:4 AX4014 error"));
    CHECK_FALSE(tests::Checked(contents, "hochlauf.lis").result.machine);
  }
  SECTION("no such axis") {
    contents["y.lis"] += "kenngr.gantry_ax_nr 99\n";
    CHECK(contains(found(contents), "y.lis:5 AX4014 error"));
    // Its list may be the one that is missing.
    contents["hochlauf.lis"] += "zahl_mds 5\n";
    CHECK_FALSE(contains(found(contents), "y.lis:5 AX4014 error"));
  }
}

TEST_CASE("AX4015: an axis of a start-up list whose list gives no number, and nothing else because of it") {
  Contents contents = controller();
  contents["y.lis"] = "kopf.log_achs_name Y_Achse\n";
  auto const lines = found(contents);
  CHECK(contains(lines, "y.lis:1 AX4015 error"));
  CHECK_FALSE(contains(lines, "sda2.lis:1 AX7006 error"));
  CHECK_FALSE(tests::Checked(contents, "hochlauf.lis").result.machine);
  SECTION("a number in the default list is none of its own") {
    contents["default.lis"] = "kopf.achs_nr 0\n";
    CHECK(contains(found(contents), "y.lis:1 AX4015 error"));
  }
  SECTION("a line that cannot be used is its own mistake") {
    contents["y.lis"] = "kopf.achs_nr two\n";
    CHECK_FALSE(contains(found(contents), "y.lis:1 AX4015 error"));
  }
  SECTION("a misspelt name is its own mistake") {
    contents["y.lis"] = "kopf.achs_nrr 2\n";
    auto const misspelt = found(contents);
    CHECK(contains(misspelt, "y.lis:1 AX2001 warning"));
    CHECK_FALSE(contains(misspelt, "y.lis:1 AX4015 error"));
  }
  SECTION("an update in XML holds only what changes") {
    contents["y.lis"] = R"(<AX_MDS><P-AXIS-00297 Value="Y"/></AX_MDS>)";
    CHECK_FALSE(contains(found(contents), "y.lis:1 AX4015 error"));
  }
}

}  // namespace start_up_test
