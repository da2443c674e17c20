// What the rules about single parameters say, and what they repair.
#include "support/catch.hpp"
#include "support/checked.hpp"

#include <algorithm>

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

struct Said {
  std::string message, notes, help, control, fix;
};

/// The first finding of a list.
Said said(std::string const& list) {
  Checked const checked(list);
  REQUIRE_FALSE(checked.result.findings.empty());
  Finding const& finding = checked.result.findings.front();
  Said said;
  said.message = render(finding.message, Language::english);
  for (Message const& note : finding.notes) said.notes += render(note, Language::english);
  for (Message const& help : finding.help) said.help += render(help, Language::english);
  if (finding.control) said.control = finding.control->message;
  if (finding.fix) said.fix = finding.fix->edits.at(0).text;
  return said;
}

}  // namespace

TEST_CASE("a word for a number is answered by what the numbers mean") {
  Said const type = said("filter_fir.type GAUSS\n");
  CHECK_THAT(type.notes, Catch::Matchers::Contains("Gaussian (2), windowed sinc (3)"));
  CHECK(type.fix == "2");
  CHECK(type.control == "1001138");
  CHECK(said("kenngr.antr_typ sercos\n").fix == "2");
  CHECK(said("kenngr.antr_typ XY\n").fix.empty());
  CHECK(said("filter[0].order 1e400\n").fix.empty());
}

TEST_CASE("numbers that a table of numbers does not list") {
  CHECK(Checked("kenngr.antr_typ 9\n").found() == Lines{"1:17 AX2007"});
  CHECK(said("kenngr.antr_typ 9\n").control.empty());
  CHECK(Checked("kenngr.antr_typ 0x20\nkenngr.achs_mode 0x401\n").found().empty());
  CHECK(Checked("filter_fir.type 5\n").found() == Lines{"1:17 AX2005"});
}

TEST_CASE("findings cite the control where it has a number") {
  CHECK(said("filter[0].enable YES\n").control == "1019");
  CHECK(said("filter[0].guete 0.5\n").control == "110490");
  CHECK(said("filter[0].share_percent 101\n").control == "110240");
  CHECK(said("filter_fir.share 101\n").control == "110632");
  CHECK(said("vib_guard.mode 5\n").control == "110626");
  CHECK(said("filter[0].type LOWPAS\n").control == "2021");
  CHECK(said("kenngr.distc.low_pass_filter_order 7\n").control == "110664");
  CHECK(said("getriebe[0].dynamik.tr_min 2000\ngetriebe[0].dynamik.tr_geom 1000\n").control == "110276");
  CHECK(said("conv_sync.order_v_filter 1001\n").control == "50607");
  // The control's text names the lower end alone.
  CHECK(said("filter[0].guete 11\n").control.empty());
  // Nothing is known of other parameters.
  CHECK(said("kenngr.gantry_max_homing_dist -1\n").control.empty());
}

TEST_CASE("orders of conveyor tracking that must be even") {
  auto const odd = said("conv_sync.order_v_filter 21\n");
  CHECK(odd.message == "`conv_sync.order_v_filter` must be even");
  CHECK(odd.control == "50608");
  CHECK(odd.help == "the nearest values allowed are `20` and `22`");
  CHECK(said("conv_sync.order_pos_filter 9\n").control == "50605");
  CHECK(Checked("conv_sync.order_pos_filter 8\nconv_sync.order_v_filter 0\n").found().empty());
  CHECK(Checked("conv_sync.order_v_filter 1001\n").found() == Lines{"1:26 AX2005"});
}

TEST_CASE("what is written is quoted as it is written") {
  CHECK(said("filter[0].order -0x10\n").message == "`-0x10` is not a number");
  CHECK_THAT(said("filter[99999999999999999999].order 1\n").message,
             Catch::Matchers::StartsWith("index 99999999999999999999 is out of range"));
}

TEST_CASE("a value out of range is told the nearest one that is allowed") {
  CHECK(said("filter[0].guete 0.7\n").help == "the nearest value allowed is `1`");
  CHECK(said("filter[0].guete 11.5\n").help == "the nearest value allowed is `10`");
  CHECK(said("filter[0].share_percent 120\n").help == "the nearest value allowed is `100`");
  CHECK(said("vib_guard.mode 5\n").help == "the nearest value allowed is `4`");
}

TEST_CASE("a word for a switch is told its number") {
  for (std::string const word : {"YES", "ein", "An", "JA"})
    CHECK(said("filter[0].enable " + word + "\n").fix == "1");
  for (std::string const word : {"NO", "aus", "Falsch"})
    CHECK(said("filter[0].enable " + word + "\n").fix == "0");
  CHECK(said("filter[0].enable MAYBE\n").fix.empty());
}

TEST_CASE("a unit that follows a number directly is taken off, and the number converted") {
  CHECK(said("filter[0].fg_f0 40Hz\n").fix == "40");
  CHECK(said("filter[0].fg_f0 0.04kHz\n").fix == "40");
  CHECK(said("filter[0].time_constant 10ms\n").fix == "10000");
  CHECK(said("filter[0].fg_f0 40mm\n").fix.empty());
  CHECK(said("filter[0].fg_f0 Hz\n").fix.empty());
  CHECK(said("filter[0].guete 4Hz\n").fix.empty());
}

TEST_CASE("the numbers of a parameter have names in both languages") {
  Checked const checked("filter_fir.type GAUSS\n");
  CHECK(
      render(checked.result.findings.at(0).notes.at(0), Language::german) ==
      "Werte: Kein Filter (0), Gleitender Mittelwert (1), Gauß (2), Windowed-Sinc (3), Zeitverzögerung (4)");
}

TEST_CASE("lower limits next to limits that are expressions") {
  CHECK(Checked("getriebe[0].dynamik.a_overload_max 999\n").found() == Lines{"1:36 AX2005"});
  CHECK(Checked("getriebe[0].dynamik.a_overload_max 1000\n").found().empty());
  CHECK(Checked("antr.add_ready_for_operation.bit_nr -2\n").found() == Lines{"1:37 AX2005"});
  CHECK(Checked("antr.add_ready_for_operation.bit_nr -1\n").found().empty());
  CHECK(Checked("lr_hw[0].nummer 3\n").found() == Lines{"1:17 AX2005"});
}

TEST_CASE("a line that a later one overwrites keeps its error") {
  CHECK(Checked("getriebe[0].vb_eilgang P-AXIS-99999\ngetriebe[0].vb_eilgang P-AXIS-99999\n").found() ==
        Lines{"1:24 AX2010", "2:24 AX2010"});
  CHECK(Checked("getriebe[0].vb_eilgang P-AXIS-99999\ngetriebe[0].vb_eilgang P-AXIS-00212\n").found() ==
        Lines{"1:24 AX2010"});
  CHECK(Checked("getriebe[0].vb_eilgang P-AXIS-00212\ngetriebe[0].vb_eilgang P-AXIS-00212\n").found() ==
        Lines{"1:24 AX2006"});
}

TEST_CASE("AX3002 in channel lists: the low-pass of the distance control, where the cycle time is known") {
  auto const found = [](std::string const& lines, std::string const& cycle) {
    Checked const checked({{"machine.json", R"({"axes": [{"name": "X", "list": "x.lis"}], )" + cycle +
                                                R"("groups": [{"axes": ["X"], "channel_list": "sda.lis"}]})"},
                           {"x.lis", "kopf.achs_nr 1\n"},
                           {"sda.lis", "prog_start.slope.profile 1\n" + lines}},
                          "machine.json", validator::CheckOptions{});
    auto lines_found = checked.found();
    lines_found.erase(std::remove(lines_found.begin(), lines_found.end(), "- AX9006"), lines_found.end());
    return lines_found;
  };
  std::string const two_milliseconds = R"("cycle_time_us": 2000, )";
  std::string const at_limit = "dist_ctrl[0].low_pass_filter_fg_f0 250\n";
  std::string const enabled = "dist_ctrl[0].low_pass_filter_enable 1\n";
  Lines const refused{"sda.lis:2:36 AX3002"};
  CHECK(found(at_limit + enabled, two_milliseconds) == refused);
  CHECK(found(at_limit + "dist_ctrl[0].filter_type LOWPASS\n", two_milliseconds) == refused);
  CHECK(found("dist_ctrl[0].low_pass_filter_fg_f0 249.9\n" + enabled, two_milliseconds).empty());
  CHECK(found(at_limit + enabled, R"("cycle_time_us": 1000, )").empty());
  CHECK(found(at_limit, two_milliseconds).empty());
  CHECK(found(at_limit + "dist_ctrl[0].filter_type KALMAN_MA\n", two_milliseconds).empty());
  CHECK(found(at_limit + enabled, "").empty());
}
