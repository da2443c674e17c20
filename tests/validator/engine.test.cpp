// What the engine does to findings: precedence, suppression, merging, the assumed cycle time.
#include "validator/engine/engine.hpp"

#include "diagnostics/fix_batch.hpp"
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "validator/sentences.hpp"

namespace engine_test {

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

constexpr char const* low_pass = "filter[0].enable 1\nfilter[0].order 2\n";

validator::CheckOptions disabling(std::uint16_t code) {
  validator::CheckOptions options = tests::with_cycle_time();
  options.disabled = {static_cast<Code>(code)};
  return options;
}

}  // namespace

TEST_CASE("on one token only the highest finding stands") {
  SECTION("a frequency below zero is AX3003, not AX2005") {
    CHECK(Checked(std::string(low_pass) + "filter[0].fg_f0 -3\n").found() == Lines{"3:17 AX3003"});
  }
  SECTION("a disabled rule takes no part in the choice") {
    CHECK(Checked(std::string(low_pass) + "filter[0].fg_f0 -3\n", disabling(3003)).found() ==
          Lines{"3:17 AX2005"});
  }
  SECTION("a suppressed rule takes no part in the choice") {
    CHECK(Checked(std::string(low_pass) + "filter[0].fg_f0 -3 ( axisc: allow AX3003\n").found() ==
          Lines{"3:17 AX2005"});
  }
  SECTION("an error outranks a warning: out of range before unused") {
    CHECK(Checked(std::string(low_pass) + "filter[0].guete 11\n").found() == Lines{"3:17 AX2005"});
  }
  SECTION("an error outranks a warning: out of range before assigned twice") {
    CHECK(Checked("filter[0].guete 11\nfilter[0].guete 2\n").found() == Lines{"1:17 AX2005"});
  }
  SECTION("a wrong index outranks the letter case of its name") {
    CHECK(Checked("Filter[9].guete 2\n").found() == Lines{"1:1 AX2002"});
  }
  SECTION("a limit of another parameter outranks the documented range") {
    CHECK(Checked("getriebe[0].dynamik.vb_max 500000\ngetriebe[0].vb_eilgang 4294967295\n").found() ==
          Lines{"2:24 AX2015"});
  }
  SECTION("findings at several tokens of a line all stand") {
    CHECK(Checked("Filter[0].guete 11 5 P-AXIS-00001\n").found() ==
          Lines{"1:1 AX1010", "1:17 AX2005", "1:20 AX1007", "1:22 AX1011"});
  }
}

TEST_CASE("severities of the options decide what stands, and whether there is a machine") {
  std::string const negative = std::string(low_pass) + "filter[0].fg_f0 -3\n";
  validator::CheckOptions options = tests::with_cycle_time();
  SECTION("an error that is lowered hides no other error") {
    options.severities = {{Code{3003}, Severity::warning}};
    CHECK(Checked(negative, options).found() == Lines{"3:17 AX2005"});
  }
  SECTION("a warning that is raised hides an error of lower rank") {
    // Both speak of the value in line 1: AX2005 as an error, AX2006 because line 2 assigns again.
    options.severities = {{Code{2006}, Severity::error}};
    Checked const checked("filter[0].guete 11\nfilter[0].guete 2\n", options);
    CHECK(checked.found() == Lines{"1:17 AX2006"});
    CHECK_FALSE(checked.result.machine);
  }
  SECTION("a warning that is raised keeps the machine from being made") {
    options.severities = {{Code{2001}, Severity::error}};
    CHECK_FALSE(Checked("hugo 11\n", options).result.machine);
    options.severities.clear();
    CHECK(Checked("hugo 11\n", options).result.machine);
  }
  SECTION("an error that is lowered lets the machine be made") {
    options.severities = {{Code{2005}, Severity::warning}};
    Checked const checked("filter[0].guete 11\n", options);
    REQUIRE(checked.result.findings.size() == 1);
    CHECK(checked.result.findings[0].severity == Severity::warning);
    CHECK(checked.result.machine);
  }
  SECTION("a note that is raised needs no pedantic check") {
    options.severities = {{Code{3008}, Severity::warning}};
    CHECK(Checked("filter[0].order 2\n", options).found() == Lines{"1:17 AX3008"});
  }
  SECTION("AX9006 is a finding like any other") {
    options.cycle_time.reset();
    options.severities = {{Code{9006}, Severity::error}};
    Checked const checked(std::string(low_pass) + "filter[0].fg_f0 20\n", options);
    REQUIRE(checked.found() == Lines{"- AX9006"});
    CHECK(checked.result.findings[0].severity == Severity::error);
    CHECK_FALSE(checked.result.machine);
  }
}

TEST_CASE("codes are disabled by the file of the finding") {
  std::map<std::string, std::string> const files = {
      {"m.json", R"({"machine": "m", "default_list": "base.lis", "axes": [{"name": "X", "list": "x.lis"}]})"},
      {"base.lis", "filter[1].guete 0.5\n"},
      {"x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 -3\n"}};
  auto const disabling_in = [](std::string const& name, std::vector<Code> codes) {
    validator::CheckOptions options = tests::with_cycle_time();
    options.paths.push_back(
        {.covers = [name](std::string const& file) { return file == name; }, .disabled = std::move(codes)});
    return options;
  };
  Lines const all = {"base.lis:1:17 AX2005", "x.lis:3:17 AX3003"};
  CHECK(Checked(files, "m.json").found() == all);
  CHECK(Checked(files, "m.json", disabling_in("m.json", {Code{2005}, Code{3003}})).found() == all);
  CHECK(Checked(files, "m.json", disabling_in("base.lis", {Code{2005}, Code{3003}})).found() ==
        Lines{"x.lis:3:17 AX3003"});
  CHECK(Checked(files, "m.json", disabling_in("x.lis", {Code{3003}})).found() ==
        Lines{"base.lis:1:17 AX2005", "x.lis:3:17 AX2005"});
  CHECK(Checked(files, "m.json", disabling_in("x.lis", {Code{2005}, Code{3003}})).found() ==
        Lines{"base.lis:1:17 AX2005"});
  SECTION("an allowance is not blamed where its code is disabled, and AX1013 itself can be") {
    std::string const list = "filter[0].guete 2 ( axisc: allow AX2005\n";
    CHECK(Checked(list).found() == Lines{"1:34 AX1013"});
    CHECK(Checked(list, disabling_in("x.lis", {Code{2005}})).found().empty());
    CHECK(Checked(list, disabling_in("x.lis", {Code{1013}})).found().empty());
    CHECK(Checked(list, disabling_in("y.lis", {Code{2005}, Code{1013}})).found() == Lines{"1:34 AX1013"});
  }
}

TEST_CASE("a machine file with mistakes gives no machine, even where they are silenced") {
  std::map<std::string, std::string> const files = {
      {"m.json", R"({"machine": "m", "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y"}]})"},
      {"x.lis", "Ende\n"}};
  Checked const checked(files, "m.json", disabling(4020));
  CHECK(checked.found().empty());
  CHECK_FALSE(checked.result.machine);
}

TEST_CASE("AX3040 replaces AX3004 for the same filter") {
  std::string const list = "lr_param.add_interface.filter[0].enable 1\n";
  CHECK(Checked(list).found() == Lines{"1:41 AX3040"});
  CHECK(Checked(list, disabling(3040)).found() == Lines{"1:41 AX3004"});
}

TEST_CASE("comments silence on their line or on the next") {
  CHECK(Checked("filter[0].guete 11 ( axisc: allow AX2005\n").found().empty());
  CHECK(Checked("filter[0].guete 11 # axisc: allow AX2005 the drive needs it\n").found().empty());
  CHECK(Checked("# axisc: allow AX2005\nfilter[0].guete 11\n").found().empty());
  CHECK(Checked("# axisc: allow AX2005\n\nfilter[0].guete 11\n").found() ==
        Lines{"1:16 AX1013", "3:17 AX2005"});
  CHECK(Checked("filter[0].guete 11 ( axisc: allow AX2005, AX1006\n").found() == Lines{"1:43 AX1013"});
  CHECK(Checked("filter[0].guete 1,5 ( axisc: allow AX1005\n").found().empty());
}

TEST_CASE("an unused suppression can be silenced, switched off, and is judged fairly") {
  CHECK(Checked("filter[0].guete 2 ( axisc: allow AX2005, AX1013\n").found().empty());
  CHECK(Checked("filter[0].guete 2 ( axisc: allow AX2005\n", disabling(1013)).found().empty());
  CHECK(Checked("filter[0].guete 2 ( axisc: allow AX2005\n", disabling(2005)).found().empty());
  CHECK(Checked("filter[0].order 2 ( axisc: allow AX3008\n").found().empty());
  CHECK(Checked("filter[0].guete 2 ( axisc: allow AX7777\n").found() == Lines{"1:34 AX1013"});
}

TEST_CASE("notes need --pedantic") {
  validator::CheckOptions pedantic = tests::with_cycle_time();
  pedantic.pedantic = true;
  CHECK(Checked("filter[0].order 2\n").found().empty());
  CHECK(Checked("filter[0].order 2\n", pedantic).found() == Lines{"1:17 AX3008"});
}

TEST_CASE("the assumed cycle time is named once, first, and only where it counts") {
  std::string const active = std::string(low_pass) + "filter[0].fg_f0 900\n";
  Checked const assumed(active, {});
  CHECK(assumed.found() == Lines{"- AX9006", "3:17 AX3002"});
  CHECK(assumed.result.cycle_time_assumed);
  CHECK_FALSE(assumed.result.cycle_time_known);
  CHECK(assumed.result.findings.back().notes.back().sentence == validator::says::cycle_time_assumed_note);
  CHECK(Checked(active).found() == Lines{"3:17 AX3002"});
  CHECK(Checked("filter[0].order 2\n", {}).found().empty());
  CHECK_FALSE(Checked("filter[0].order 2\n", {}).result.cycle_time_assumed);
}

TEST_CASE("who takes findings one by one gets the same, and the result holds none") {
  std::string const list = std::string(low_pass) + "filter[0].fg_f0 900\nfilter[0].ordr 2\nkopf.achs_nr x\n";
  Checked const together(list, {});
  SourceSet sources;
  std::vector<Code> one_by_one;
  tests::MapFiles files({{"x.lis", list}});
  auto const result = validator::check(files, "x.lis", {}, sources,
                                       [&](Finding const& finding) { one_by_one.push_back(finding.code); });
  std::vector<Code> expected;
  for (Finding const& finding : together.result.findings) expected.push_back(finding.code);
  CHECK(one_by_one == expected);
  CHECK(one_by_one.front() == Code{9006});
  CHECK(result.findings.empty());
  CHECK(result.cycle_time_assumed);
}

TEST_CASE("findings of a list that several axes share are reported once") {
  std::string const machine = R"({"cycle_time_us": 1000, "default_list": "d.lis",
      "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}, {"name": "Z", "list": "x.lis"}]})";
  Checked const checked(
      {
          {"m.json", machine},
          {"d.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 900\nfilter[0].guete 11\n"},
          {"x.lis", "kopf.achs_nr 70000\n"},
          {"y.lis", "kopf.achs_nr 2\n"},
      },
      "m.json");
  CHECK(checked.found() == Lines{"d.lis:3:17 AX3002", "d.lis:4:17 AX2005", "x.lis:1:14 AX2004"});
  for (Finding const& finding : checked.result.findings) CHECK(finding.axis.empty());
  CHECK(checked.files.reads.at("x.lis") == 1);
}

TEST_CASE("a finding names its axis, parameter and number") {
  Checked const checked("kopf.log_achs_name Tisch\nfilter[1].guete 11\n");
  REQUIRE(checked.result.findings.size() == 1);
  Finding const& finding = checked.result.findings.front();
  CHECK(finding.axis == "Tisch");
  CHECK(finding.parameter == "filter[1].guete");
  CHECK(finding.p_axis == "P-AXIS-00080");
  CHECK(finding.name == "out-of-range");
}

TEST_CASE("a suppression that silences nothing can be taken out, code by code") {
  auto const repaired = [](std::string const& list) {
    Checked const checked(list);
    FixBatch batch(checked.sources);
    for (Finding const& finding : checked.result.findings) {
      if (finding.code != Code{1013}) continue;
      REQUIRE(finding.fix);
      CHECK(finding.fix->safety == FixSafety::safe);
      CHECK(batch.add(*finding.fix));
    }
    auto const edited = batch.apply();
    return edited.empty() ? list : edited.front().bytes;
  };
  CHECK(repaired("filter[0].guete 2 ( axisc: allow AX2005\n") == "filter[0].guete 2 (\n");
  CHECK(repaired("filter[0].guete 2 ( high) # axisc: allow AX2005 as agreed\n") ==
        "filter[0].guete 2 ( high) # as agreed\n");
  CHECK(repaired("# axisc: allow AX2005\nfilter[0].guete 2\n") == "#\nfilter[0].guete 2\n");
  CHECK(repaired("filter[0].guete 11 ( axisc: allow AX2005, AX1006 why\n") ==
        "filter[0].guete 11 ( axisc: allow AX2005 why\n");
  CHECK(repaired("filter[0].guete 11 ( axisc: allow AX1006, AX2005\n") ==
        "filter[0].guete 11 ( axisc: allow AX2005\n");
  CHECK(repaired("filter[0].guete 11 ( axisc: allow AX2005\n") ==
        "filter[0].guete 11 ( axisc: allow AX2005\n");
}

TEST_CASE("the value that the control takes is said in its unit too") {
  auto const reaction = [](std::string const& list) {
    Checked const checked(list);
    REQUIRE(checked.result.findings.size() == 1);
    return *checked.result.findings.front().control;
  };
  ControlReaction const clipped = reaction("filter[0].time_constant 99999999999\n");
  CHECK(clipped.value == "4294967295");
  CHECK(clipped.physical == "4294967.295 ms");
  ControlReaction const lost = reaction("getriebe[0].dynamik.a_max P-AXIS-09999\n");
  CHECK(lost.message == "2052");
  CHECK(lost.value == "1000");
  CHECK(lost.physical == "1000 mm/s\xC2\xB2");
  CHECK(reaction("antr.v_time_base 70000\n").physical.empty());
}

TEST_CASE("a comment silences so many codes and no more") {
  std::string codes = "AX1005";
  for (int i = 1; i < 256; ++i) codes += ", AX1005";
  std::string const line = "filter[0].fg_f0 1,5 ( axisc: allow ";
  CHECK(Checked(line + codes + "\nEnde\n").found().empty());
  auto const found = Checked(line + codes + ", AX1005, AX1005\nEnde\n").found();
  CHECK(found == Lines{"1:" + std::to_string(line.size() + codes.size() + 1) + " AX1013"});
}

}  // namespace engine_test
