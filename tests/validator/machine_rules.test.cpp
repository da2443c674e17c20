// Rules about several axes together: delays within a channel, gantries, axis numbers.
#include "support/catch.hpp"
#include "support/checked.hpp"

#include <algorithm>

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

struct Axis {
  std::string name;
  std::string lines;
  std::string keys;  ///< more keys of the machine file
};

/// A machine at 1 ms whose axes have the lists x.lis, y.lis, … and the numbers 1, 2, …
Checked machine_text(std::vector<Axis> const& axes, std::string const& keys = "", bool pedantic = false) {
  std::map<std::string, std::string> files;
  std::string named;
  int number = 0;
  for (Axis const& axis : axes) {
    named += std::string(named.empty() ? "" : ", ") + R"({"name": ")" + axis.name + R"(", "list": ")" +
             axis.name + ".lis\"" + axis.keys + "}";
    files[axis.name + ".lis"] = "kopf.achs_nr " + std::to_string(++number) + "\n" + axis.lines;
  }
  files["m.json"] = R"({"cycle_time_us": 1000, "axes": [)" + named + "]" + keys + "}";
  validator::CheckOptions options;
  options.pedantic = pedantic;
  options.disabled.push_back(Code{2017});  // these lists say only what their test needs
  return {files, "m.json", options};
}

Lines found(std::vector<Axis> const& axes, std::string const& keys = "", bool pedantic = false) {
  return machine_text(axes, keys, pedantic).found();
}

std::string fir(int type, int order) {
  return "filter_fir.enable 1\nfilter_fir.type " + std::to_string(type) + "\nfilter_fir.order " +
         std::to_string(order) + "\n";
}

/// A file with the edits of a fix applied.
std::string fixed(Checked const& checked, Finding const& finding, std::string const& file) {
  std::string text;
  std::vector<Edit> edits;
  for (Edit const& edit : finding.fix->edits) {
    if (checked.sources[edit.place.source].name() != file) continue;
    text = checked.sources[edit.place.source].bytes();
    edits.insert(edits.begin(), edit);
  }
  std::sort(edits.begin(), edits.end(), [](Edit const& a, Edit const& b) { return b.place < a.place; });
  for (Edit const& edit : edits) {
    text.replace(edit.place.span.begin, edit.place.span.end - edit.place.span.begin, edit.text);
  }
  return text;
}

std::string const ipc =
    "lr_param.improved_position_control.enable 1\n"
    "lr_param.improved_position_control.v_add_max_fact 100\n"
    "lr_param.improved_position_control.stage[0].mode DIRECT\n"
    "lr_param.improved_position_control.stage[0].filter.order 1\n"
    "lr_param.improved_position_control.stage[0].filter.fg_f0 53\n"
    "lr_param.improved_position_control.stage[0].filter.q_factor 2\n";

constexpr char const* gantry = R"(, "gantries": [{"master": "x", "slaves": ["x2"]}])";

}  // namespace

TEST_CASE(
    "AX4011: feedforward delays its axis by 5 cycles more; a time delay in the other one makes up for it") {
  std::string const feedforward =
      "kenngr.antr_typ 2\nvorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n";
  std::string const without = "kenngr.antr_typ 2\n";
  CHECK(found({{"x", feedforward, ""}, {"y", without + fir(4, 5), ""}}).empty());
  CHECK(found({{"x", feedforward, ""}, {"y", without, ""}}) == Lines{"x.lis:4:26 AX4024"});
  CHECK(found({{"x", feedforward + fir(4, 5), ""}, {"y", without, ""}}) == Lines{"x.lis:7:18 AX4011"});
}

TEST_CASE("AX4011: axes of a channel that are delayed differently") {
  CHECK(found({{"x", fir(1, 20), ""}, {"y", fir(1, 20), ""}}).empty());
  CHECK(found({{"x", fir(1, 20), ""}, {"y", "", ""}}) == Lines{"x.lis:4:18 AX4011"});
  CHECK(found({{"x", fir(1, 20), ""}, {"y", fir(1, 22), ""}}) == Lines{"y.lis:4:18 AX4011"});
  CHECK(found({{"x", fir(1, 19), ""}, {"y", fir(1, 20), ""}}).empty());
  CHECK(found({{"x", "filter_fir.type 1\nfilter_fir.order 20\n", ""}, {"y", "", ""}}) ==
        Lines{"x.lis:3:18 AX4011"});
  CHECK(found({{"x", "filter[0].prototype HSC\n", ""}, {"y", "", ""}}) == Lines{"x.lis:2:21 AX4011"});
}

TEST_CASE("AX4011: filters that agree, of which one does not work from start-up") {
  std::string const off = "filter_fir.type 1\nfilter_fir.order 20\n";
  Checked const checked = machine_text({{"x", fir(1, 20), ""}, {"y", off, ""}});
  REQUIRE(checked.found() == Lines{"x.lis:4:18 AX4011"});
  Finding const& finding = checked.result.findings.front();
  CHECK(render(finding.message, Language::english) ==
        "the axes of the channel are out of step from start-up on: their filter delays differ by 10 cycles "
        "(10 ms)");
  CHECK_FALSE(finding.fix);
  CHECK(found({{"x", off, ""}, {"y", off, ""}}).empty());
  CHECK(found({{"x", off, ""}, {"y", "filter_fir.type 4\nfilter_fir.order 10\n", ""}}).empty());
  // A HSC filter waits for its command, a time delay does not.
  CHECK(found({{"x", "filter[0].prototype HSC\nfilter[0].order 20\n", ""}, {"y", fir(4, 10), ""}}) ==
        Lines{"y.lis:4:18 AX4011"});
}

TEST_CASE("AX4011's time delay is on where the other filter is, and beside a HSC filter there is none") {
  Checked const off = machine_text({{"x", "filter_fir.type 1\nfilter_fir.order 20\n", ""}, {"y", "", ""}});
  REQUIRE(off.found() == Lines{"x.lis:3:18 AX4011"});
  CHECK(fixed(off, off.result.findings.front(), "y.lis") ==
        "kopf.achs_nr 2\nfilter_fir.type 4\nfilter_fir.order 10\n");
  Checked const hsc =
      machine_text({{"x", "filter[0].prototype HSC\nfilter[0].order 20\n", ""}, {"y", "", ""}});
  REQUIRE(hsc.found() == Lines{"x.lis:3:17 AX4011"});
  CHECK_FALSE(hsc.result.findings.front().fix);
}

TEST_CASE("AX4011: standard filters delay too") {
  std::string const delay =
      "filter[0].enable 1\nfilter[0].order 1\nfilter[0].type TIME_DELAY\nfilter[0].time_constant ";
  CHECK(found({{"x", delay + "400\n", ""}, {"y", "", ""}}).empty());
  CHECK(found({{"x", delay + "500\n", ""}, {"y", "", ""}}) == Lines{"x.lis:2:18 AX4011"});
  CHECK(found({{"x", delay + "5000\n", ""}, {"y", fir(1, 10), ""}}).empty());
  CHECK(found({{"x", delay + "6000\n", ""}, {"y", "", ""}}) == Lines{"x.lis:5:25 AX3005"});
}

TEST_CASE("AX4011: spindles, other channels and the group of the machine file") {
  CHECK(found({{"x", fir(1, 20), ""}, {"s", "", R"(, "type": "S")"}}).empty());
  CHECK(found({{"x", fir(1, 20), ""}, {"y", "", ""}}, R"(, "groups": [{"axes": ["x"]}, {"axes": ["y"]}])")
            .empty());
  CHECK(found({{"x", fir(1, 20), ""}, {"s", "", R"(, "type": "S")"}},
              R"(, "groups": [{"axes": ["x", "s"]}])") == Lines{"x.lis:4:18 AX4011"});
}

TEST_CASE("AX4011 says how far the axes are apart, and writes the time delay that repairs it") {
  Checked const checked = machine_text({{"x", fir(1, 21), ""},
                                        {"y", "Ende\n", ""},
                                        {"z", "filter_fir.enable 0\nfilter_fir.type 0\nEnde\n", ""}});
  REQUIRE(checked.found() == Lines{"x.lis:4:18 AX4011"});
  Finding const& finding = checked.result.findings.front();
  CHECK(render(finding.message, Language::english) ==
        "the axes of the channel are out of step: their filter delays differ by 11 cycles (11 ms)");
  CHECK(finding.axis == "x");
  REQUIRE(finding.fix);
  CHECK(finding.fix->safety == FixSafety::changes_behaviour);
  CHECK(fixed(checked, finding, "y.lis") ==
        "kopf.achs_nr 2\nfilter_fir.enable 1\nfilter_fir.type 4\nfilter_fir.order 11\nEnde\n");
  CHECK(fixed(checked, finding, "z.lis") ==
        "kopf.achs_nr 3\nfilter_fir.enable 1\nfilter_fir.type 4\nfilter_fir.order 11\nEnde\n");
}

TEST_CASE(
    "AX4011 is at the axis that is out of step with a majority, and at the filter that makes the "
    "difference") {
  std::string const band_stop =
      "filter[1].enable 1\nfilter[1].order 1\nfilter[1].type BANDSTOP\nfilter[1].guete 1\nfilter[1].fg_f0 "
      "40\n";
  Checked const checked = machine_text({{"x", fir(1, 40) + band_stop, ""},
                                        {"y", fir(1, 40), ""},
                                        {"z", fir(1, 40), ""},
                                        {"c", fir(1, 40), ""}});
  auto const finding = std::find_if(checked.result.findings.begin(), checked.result.findings.end(),
                                    [](Finding const& each) { return each.code == Code{4011}; });
  REQUIRE(finding != checked.result.findings.end());
  CHECK(finding->axis == "x");
  CHECK(checked.place_text(*finding) == "x.lis:5:18 ");
  CHECK(finding->related.empty());
  std::string notes;
  for (Message const& note : finding->notes) notes += render(note, Language::english) + "\n";
  CHECK_THAT(notes, Catch::Matchers::Contains("`filter[1]` makes the difference"));
  CHECK_THAT(render(*finding->label, Language::english), Catch::Matchers::Contains("`filter_fir` 20"));
  CHECK_THAT(render(*finding->label, Language::english), Catch::Matchers::Contains("`filter[1]` "));
  // The one that lacks what the others have: at the last of those.
  CHECK(found({{"x", "", ""}, {"y", fir(1, 40), ""}, {"z", fir(1, 40), ""}}) == Lines{"z.lis:4:18 AX4011"});
}

TEST_CASE("AX4021: master and slave of a gantry have the same filters") {
  std::string const groups = std::string(gantry) + R"(, "groups": [{"name": "1", "axes": ["x"]}])";
  auto const pair = [&](std::string const& master, std::string const& slave) {
    return machine_text({{"x", "getriebe[0].dynamik.vb_max 500000\n" + master, ""},
                         {"x2", "getriebe[0].dynamik.vb_max 500000\n" + slave, ""}},
                        groups);
  };
  CHECK(pair(fir(1, 40), fir(1, 40)).found().empty());
  CHECK(pair("", "").found().empty());
  Checked const checked = pair(fir(1, 40), "");
  REQUIRE(checked.found() == Lines{"x.lis:5:18 AX4021"});
  Finding const& finding = checked.result.findings.front();
  CHECK(finding.severity == Severity::error);
  CHECK(render(finding.message, Language::english) ==
        "gantry \"x\"/\"x2\": the filters of master and slave are 20 cycles (20 ms) apart");
  REQUIRE(finding.notes.size() == 3);
  CHECK(render(finding.notes[2], Language::english) ==
        "at the master's `getriebe[0].dynamik.vb_max` (P-AXIS-00212), 500 mm/s, the portal skews by 10 mm");
  CHECK(pair(fir(1, 20), fir(1, 40)).found() == Lines{"x2.lis:5:18 AX4021"});
  // The same delay, another response; and a filter that is off at start-up.
  CHECK(pair(fir(1, 40), fir(4, 20)).found() == Lines{"x2.lis:5:18 AX4021"});
  std::string const off = "filter_fir.type 1\nfilter_fir.order 40\n";
  CHECK(pair(fir(1, 40), off).found() == Lines{"x2.lis:4:18 AX4021"});
  // What is on is named: the slave has no other filter.
  for (auto const& [master, note] :
       {std::pair(fir(1, 40), "the linear-phase filter works in \"x\" alone (`filter_fir.enable`)"),
        std::pair(std::string("vib_guard.active 1\nvib_guard.freq 30\nvib_guard.damping 0.1\n"),
                  "the Vibration Guard works in \"x\" alone (`vib_guard.active`)")}) {
    Checked const lone = pair(master, "");
    std::string notes;
    for (Message const& each : lone.result.findings.front().notes) notes += render(each, Language::english);
    CHECK_THAT(notes, Catch::Matchers::Contains(note));
  }
  // In one channel it is one mistake.
  CHECK(found({{"x", fir(1, 40), ""}, {"x2", "", ""}}, gantry) == Lines{"x.lis:4:18 AX4021"});
  // Without filters: five cycles between interpolator and position controller where feedforward is used.
  std::string const forward = "vorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n";
  CHECK(pair(forward, forward).found().empty());
  Checked const fed = pair("", forward);
  REQUIRE(fed.found() == Lines{"x2.lis:4:26 AX4021"});
  CHECK(render(fed.result.findings.front().message, Language::english) ==
        "gantry \"x\"/\"x2\": the positions of master and slave are 5 cycles (5 ms) apart");
  // Both: the filter delays by 20 cycles, 5 of which feedforward makes up for.
  Checked const both = pair(fir(1, 40), forward);
  REQUIRE(both.found() == Lines{"x.lis:5:18 AX4021"});
  CHECK_THAT(render(both.result.findings.front().message, Language::english),
             Catch::Matchers::Contains("the positions of master and slave are 15 cycles"));
}

TEST_CASE("AX4023: master and slave of a gantry have the same limits") {
  auto const limits = [](std::string const& velocity, std::string const& acceleration) {
    return "getriebe[0].dynamik.vb_max " + velocity + "\ngetriebe[0].dynamik.a_max " + acceleration + "\n";
  };
  CHECK(found({{"x", limits("500000", "3000"), ""}, {"x2", limits("500000", "3000"), ""}}, gantry).empty());
  CHECK(found({{"x", limits("500000", "3000"), ""}, {"x2", limits("400000", "2000"), ""}}, gantry) ==
        Lines{"x2.lis:2:28 AX4023", "x2.lis:3:27 AX4023"});
  CHECK(found({{"x", limits("500000", "3000"), ""}, {"x2", "", ""}}, gantry) ==
        Lines{"x.lis:2:28 AX4023", "x.lis:3:27 AX4023"});
}

TEST_CASE("AX4011 offers no fix where an axis has a linear-phase filter already") {
  Checked const two = machine_text({{"x", fir(1, 20), ""}, {"y", fir(1, 40), ""}});
  REQUIRE(two.result.findings.size() == 1);
  CHECK_FALSE(two.result.findings.front().fix);
  CHECK(two.result.findings.front().related.size() == 1);
  Checked const guarded = machine_text({{"x", fir(1, 20), ""}, {"y", "vib_guard.active 1\n", ""}});
  REQUIRE(guarded.result.findings.size() == 1);
  CHECK_FALSE(guarded.result.findings.front().fix);
}

TEST_CASE("AX4010: different filters with the same delay") {
  std::vector<Axis> const delayed{{"x", fir(1, 20), ""}, {"y", fir(4, 10), ""}};
  CHECK(found(delayed).empty());
  CHECK(found(delayed, "", true) == Lines{"y.lis:4:18 AX4010"});
  CHECK(found({{"x", fir(1, 20), ""}, {"y", "filter_fir.type 1\nfilter_fir.order 20\n", ""}}, "", true) ==
        Lines{"x.lis:4:18 AX4011"});
  CHECK(found({{"x", fir(1, 20), ""}, {"y", fir(1, 20) + "filter_fir.fcut 30\n", ""}}, "", true).empty());
}

TEST_CASE("AX4012: position control in a gantry slave, of lists and of the machine file") {
  std::string const scaled = "antr.v_reso_num 100\n" + ipc;
  CHECK(found({{"x", "", ""}, {"x2", scaled, ""}}, gantry) == Lines{"x2.lis:3:43 AX4012"});
  CHECK(found({{"x", scaled, ""}, {"x2", "", ""}}, gantry).empty());
  CHECK(found({{"x", "kenngr.achs_mode 0x10001\n", ""},
               {"x2", "kenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 1\n" + scaled, ""}}) ==
        Lines{"x2.lis:5:43 AX4012"});
}

TEST_CASE("AX4013: velocity scaling of master and slave") {
  std::string const drive = R"(, "position_control": "drive")";
  std::string const scaling = "antr.v_reso_num 100\nantr.v_reso_denom 7\n";
  CHECK(found({{"x", scaling + ipc, drive}, {"x2", scaling, ""}}, gantry).empty());
  CHECK(found({{"x", scaling + ipc, drive}, {"x2", "antr.v_reso_num 100\nantr.v_reso_denom 8\n", ""}},
              gantry) == Lines{"x2.lis:3:19 AX4013"});
  CHECK(found({{"x", scaling + ipc, drive}, {"x2", "", ""}}, gantry) == Lines{"x.lis:3:19 AX4013"});
  CHECK(found({{"x", scaling + ipc, R"(, "position_control": "cnc")"}, {"x2", "", ""}}, gantry).empty());
  CHECK(found({{"x", scaling, drive}, {"x2", "", ""}}, gantry).empty());
}

TEST_CASE("AX4014: a gantry of the lists that is not complete") {
  std::string const slave = "kenngr.achs_mode 0x20001\n";
  std::string const of_x = slave + "kenngr.gantry_ax_nr 1\n";
  CHECK(found({{"x", "kenngr.achs_mode 0x10001\n", ""}, {"x2", of_x, ""}}).empty());
  CHECK(found({{"x", "kenngr.achs_mode 0x10001\n", ""}, {"x2", slave, ""}}) == Lines{"x2.lis:2:18 AX4014"});
  CHECK(found({{"x", "", ""}, {"x2", slave + "kenngr.gantry_ax_nr 5\n", ""}}) == Lines{"x2.lis:3:21 AX4014"});
  CHECK(found({{"x", "", ""}, {"x2", slave + "kenngr.gantry_ax_nr 2\n", ""}}) == Lines{"x2.lis:3:21 AX4014"});
  CHECK(found({{"x", "", ""}, {"x2", of_x, ""}}) == Lines{"x2.lis:3:21 AX4014"});
  CHECK(found({{"x", "kenngr.achs_mode 0x1\n", ""}, {"x2", of_x, ""}}) == Lines{"x2.lis:3:21 AX4014"});
  CHECK(found({{"x2", of_x.substr(0, slave.size()) + "kenngr.gantry_ax_nr 2\n", ""},
               {"x", "kenngr.achs_mode 0x4\n", ""}}) == Lines{"x.lis:2:18 AX4014"});
}

TEST_CASE("AX4014: the machine file adds what the lists leave open, and may not contradict them") {
  CHECK(found({{"x", "", ""}, {"x2", "", ""}}, gantry).empty());
  CHECK(found({{"x", "", ""}, {"x2", "kenngr.achs_mode 0x20001\n", ""}}, gantry).empty());
  CHECK(found({{"x", "kenngr.achs_mode 1\n", ""}, {"x2", "kenngr.achs_mode 1\n", ""}}, gantry).empty());
  CHECK(found({{"x", "kenngr.achs_mode 4\n", ""}, {"x2", "", ""}}, gantry) == Lines{"x.lis:2:18 AX4014"});
  CHECK(found({{"x", "", ""}, {"x2", "kenngr.achs_mode 4\n", ""}}, gantry) == Lines{"x2.lis:2:18 AX4014"});
  CHECK(found({{"x", "", ""},
               {"x2", "kenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 3\n", ""},
               {"y", "kenngr.achs_mode 0x10001\n", ""}},
              gantry) == Lines{"x2.lis:3:21 AX4014"});
}

TEST_CASE("AX1014: a default list is in the units of its axes, where they are of one type") {
  auto const machine = [](std::string const& x, std::string const& c) {
    return Checked(
               {{"m.json",
                 R"({"cycle_time_us": 1000, "default_list": "d.lis", "axes": [{"name": "X", "list": "x.lis"},
                         {"name": "C", "list": "c.lis"}]})"},
                {"d.lis", "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 20 mm/s^2\n"},
                {"x.lis", "kopf.achs_nr 1\nkenngr.achs_typ " + x + "\n"},
                {"c.lis", "kopf.achs_nr 2\nkenngr.achs_typ " + c + "\nkenngr.swe_pos 10 Grad\n"}},
               "m.json")
        .found();
  };
  CHECK(machine("1", "1") == Lines{"c.lis:3:19 AX1014"});
  CHECK(machine("1", "2") == Lines{"c.lis:3:19 AX1014"});
  CHECK(machine("2", "2") == Lines{"d.lis:2:30 AX1014", "c.lis:3:19 AX1014"});
  CHECK(machine("2", "4") == Lines{"d.lis:2:30 AX1014", "c.lis:3:19 AX1014"});
}

TEST_CASE("AX4015: numbers of axes and of the default list") {
  std::map<std::string, std::string> files{
      {"m.json",
       R"({"cycle_time_us": 1000, "default_list": "d.lis", "axes": [{"name": "X", "list": "x.lis"},
           {"name": "Y", "list": "y.lis"}, {"name": "Z", "list": "x.lis"}]})"},
      {"d.lis", "kopf.achs_nr 5\n"},
      {"x.lis", "kopf.achs_nr 1\n"},
      {"y.lis", "kopf.achs_nr 0\n"}};
  CHECK(Checked(files, "m.json").found() ==
        Lines{"d.lis:1:14 AX4015", "x.lis:1:14 AX4015", "y.lis:1:14 AX4015"});
  files["d.lis"] = "kopf.achs_nr 5\nkopf.achs_nr 0\n";
  files["x.lis"] = "# X\n";
  files["y.lis"] = "kopf.achs_nr 1\n";
  CHECK(Checked(files, "m.json").found() == Lines{"d.lis:1:14 AX2006"});
}

TEST_CASE("AX3038 and AX4016: the machine file's drive wins over the list's") {
  std::string const scaled = "antr.v_reso_num 100\n" + ipc;
  CHECK(found({{"x", "kenngr.antr_typ 4\n" + scaled, R"(, "drive": "CANopen")"}}).empty());
  Checked const simulated =
      machine_text({{"x", "kenngr.antr_typ 2\n" + scaled, R"(, "drive": "simulation")"}});
  CHECK(simulated.found() == Lines{"1:74 AX3038"});
  CHECK(simulated.result.findings.front().axis == "x");
  CHECK(found({{"x", ipc, R"(, "drive": "SERCOS")"}}) == Lines{"x.lis:2:43 AX4016"});
  CHECK(found({{"x", ipc, R"(, "drive": "SERCOS", "position_control": "cnc")"}}).empty());
  CHECK(found({{"x", ipc, R"(, "position_control": "drive")"}}) == Lines{"x.lis:2:43 AX4016"});
}
