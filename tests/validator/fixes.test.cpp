// What fixes write, and where there is none because only a person knows what was meant.
#include "diagnostics/fix_batch.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace fixes_test {

namespace {

using namespace axisc;

/// The text with the fix of the first finding of that code; "none" where it has none, "no finding" without a
/// finding.
std::string fixed(std::string const& name, std::string const& text, Code code) {
  tests::MapFiles files(std::map<std::string, std::string>{{name, text}});
  SourceSet sources;
  validator::CheckOptions options;
  options.cycle_time = design::CycleTime{1'000'000};
  options.whole_programs = true;
  auto const findings = validator::check(files, name, options, sources).findings;
  auto const finding = std::find_if(findings.begin(), findings.end(),
                                    [code](Finding const& each) { return each.code == code; });
  if (finding == findings.end()) return "no finding";
  if (!finding->fix) return "none";
  FixBatch batch(sources);
  batch.add(*finding->fix);
  return batch.apply().front().bytes;
}

std::string line(std::string const& text, std::uint16_t code) {
  return fixed("x.lis", text, Code{code});
}
std::string block(std::string const& text, std::uint16_t code) {
  return fixed("x.nc", text, Code{code});
}

}  // namespace

TEST_CASE("names") {
  CHECK(line("fir_filter.type 1", 2001) == "filter_fir.type 1");
  CHECK(line("vib_guard.order 30", 2001) == "filter_fir.order 30");
  CHECK(line("getriebe[0].vb_max 5", 2001) == "getriebe[0].dynamik.vb_max 5");
  CHECK(line("lr_param.ipc.enable 1", 2001) == "lr_param.improved_position_control.enable 1");
  CHECK(line("filter[0].oder 2 ( P-AXIS-00140", 2001) == "filter[0].order 2 ( P-AXIS-00140");
  CHECK(line("filter[0].oder 2 ( P-CHAN-00140\nkopf.achs_nr 1\nkopf.mds_ident 1", 2001) == "none");
  CHECK(line("path[0].type 3\nkopf.achs_nr 1\nkopf.mds_ident 1", 2001) == "none");
  CHECK(line("filter [0].order 2", 1004) == "filter[0].order 2");
  CHECK(line("filter[0,1].order 2", 1004) == "none");
  CHECK(line("filter[0.order 2", 1004) == "filter[0].order 2");
}

TEST_CASE("joined words are corrected one by one") {
  CHECK(line("vorsteuer.vorsteuerung ADD_VEL | ADD_AC", 2007) == "vorsteuer.vorsteuerung ADD_VEL | ADD_ACC");
  CHECK(line("vorsteuer.vorsteuerung VEL |", 2007) == "none");
}

TEST_CASE("a fix that decides between two values is none of the safe ones") {
  auto const safety = [](std::string const& text, std::uint16_t code) -> std::string {
    tests::MapFiles files(std::map<std::string, std::string>{{"x.lis", text}});
    SourceSet sources;
    validator::CheckOptions options;
    options.cycle_time = design::CycleTime{1'000'000};
    for (Finding const& finding : validator::check(files, "x.lis", options, sources).findings) {
      if (finding.code != Code{code}) continue;
      if (!finding.fix) return "none";
      return finding.fix->safety == FixSafety::safe ? "safe" : "all";
    }
    return "no finding";
  };
  CHECK(safety("filter[0].order 2\nfilter[0].order 0x2\n", 2006) == "safe");
  CHECK(safety("filter[0].order 2\nfilter[0].order 3\n", 2006) == "all");
  // The control may ignore the second name.
  CHECK(safety("filter[0].order 2\nFilter[0].order 2\n", 2006) == "all");
  CHECK(safety("filter[0].order 2\nFilter[0].order 2\n", 1010) == "all");
  CHECK(safety("Filter[0].order 2\n", 1010) == "safe");
  // A reference that leads nowhere changes nothing, and one that leads to itself is no value.
  CHECK(safety("filter[0].fg_f0 20\nfilter[0].fg_f0 P-AXIS-99999\n", 2006) == "no finding");
  CHECK(safety("filter[0].fg_f0 20\nfilter[0].fg_f0 P-AXIS-00067\n", 2006) == "none");
}

TEST_CASE("a slip in a family that is compiled is an error") {
  auto const is_error = [](std::string const& text) {
    tests::MapFiles files(std::map<std::string, std::string>{{"x.lis", text}});
    SourceSet sources;
    auto const findings = validator::check(files, "x.lis", {}, sources).findings;
    return !findings.empty() && findings.front().severity == Severity::error;
  };
  for (char const* const name :
       {"filter[0].foo", "filtr[0].foo", "fir_filter.foo", "fir_filter.type", "vib_gard.foo",
        "lr_param.add_interfce.foo", "lr_param.ipc.enable", "vib_guard.order"}) {
    INFO(name);
    CHECK(is_error(std::string(name) + " 1"));
  }
  for (char const* const name :
       {"path[0].type", "folder.foo", "getriebe[0].vb_max", "lr_param.foo", "hugo.egon"}) {
    INFO(name);
    CHECK_FALSE(is_error(std::string(name) + " 1"));
  }
}

TEST_CASE("numbers") {
  CHECK(line("getriebe[0].dynamik.vb_max 500.000", 2003) == "none");
  CHECK(line("getriebe[0].dynamik.vb_max 500.0", 2003) == "getriebe[0].dynamik.vb_max 500");
  CHECK(line("filter[0].fg_f0 4 0", 1007) == "none");
  CHECK(line("filter[0].order 4( order", 1006) == "filter[0].order 4 ( order");
  CHECK(line("filter[0].fg_f0 0.04 kHz", 1014) == "filter[0].fg_f0 40 ( 0.04 kHz");
  CHECK(line("filter[0].time_constant 10 ms", 1014) == "filter[0].time_constant 10000 ( 10 ms");
  CHECK(line("getriebe[0].dynamik.vb_max 30000 mm/min", 1014) ==
        "getriebe[0].dynamik.vb_max 500000 ( 30000 mm/min");
  CHECK(line("getriebe[0].dynamik.a_max 2 m/s\xC2\xB2", 1014) ==
        "getriebe[0].dynamik.a_max 2000 ( 2 m/s\xC2\xB2");
  CHECK(line("kenngr.swe_pos 360 deg", 1014) == "kenngr.swe_pos 3600000 ( 360 deg");
  CHECK(line("filter[0].time_constant 0.3 us", 1014) == "no finding");
  CHECK(line("filter[0].fg_f0 40 ms", 1014) == "none");
  CHECK(line("filter[0].fg_f0 40 Hz", 1014) == "no finding");
  CHECK(line("filter[0].order 4 ms", 1014) == "no finding");
}

TEST_CASE("signs, line ends and characters") {
  CHECK(line("filter[0].enable = 1", 1002) == "filter[0].enable 1");
  CHECK(line("filter[0].enable: 1", 1002) == "filter[0].enable 1");
  CHECK(line("filter[0].enable=1", 1002) == "filter[0].enable 1");
  CHECK(line("filter[0].type = LOWPASS", 1002) == "filter[0].type LOWPASS");
  CHECK(line("http://x", 1002) == "none");
  CHECK(line("  filter[0].order 2   filter[0].enable 1\r\nEnde\r\n", 1016) ==
        "  filter[0].order 2\r\nfilter[0].enable 1\r\nEnde\r\n");
  CHECK(line("filter[0].type LOWPASS filter[0].enable 1\n", 1016) ==
        "filter[0].type LOWPASS\nfilter[0].enable 1\n");
  CHECK(line("filter[0].enable\xC2\xA0"
             "1",
             1001) == "filter[0].enable 1");
  CHECK(line("filter[0].enable\xA0"
             "1",
             1001) == "filter[0].enable 1");
  CHECK(line("filter[0].order 4\xC2\xA0", 1001) == "filter[0].order 4 ");
  CHECK(line("filter[0].enable 1\xE2\x80\x8B", 1001) == "filter[0].enable 1");
  CHECK(line("filter[0].\xD0\xBErder 2", 1001) == "filter[0].order 2");
  CHECK(line("filter[0].type L\xD0\x9EWPASS", 1001) == "filter[0].type LOWPASS");
  CHECK(line("filter[0].fg_f0 \xE2\x88\x92"
             "5",
             1001) == "filter[0].fg_f0 -5");
  CHECK(line("filter[0].order 4 \xC2\xA0( order", 1001) == "no finding");
}

TEST_CASE("the end of a list") {
  CHECK(line("kopf.achs_nr 1\nEND\n", 1003) == "kopf.achs_nr 1\nEnde\n");
  CHECK(line("kopf.achs_nr 1\nEnde.\n# comment\n", 1002) == "kopf.achs_nr 1\nEnde\n# comment\n");
  CHECK(line("kopf.achs_nr 1\nEND\nkopf.mds_ident 1\n", 1003) == "none");
  CHECK(line("kopf.achs_nr 1\nEnde\nkopf.mds_ident 1\n", 1008) == "none");
}

TEST_CASE("directives") {
  CHECK(line("kopf.achs_nr 1 ( axisc: allow filter-order-for-type", 1013) == "kopf.achs_nr 1 (");
  CHECK(line("kopf.achs_nr 1 ( axisc: allow filter-order-for-typ", 1013) == "kopf.achs_nr 1 (");
  CHECK(line("kopf.achs_nr 1 ( axisc: disable AX3001", 1013) == "kopf.achs_nr 1 ( axisc: allow AX3001");
}

TEST_CASE("commands") {
  CHECK(block("N1 #FILTR ON [ORDER=20]", 5001) == "N1 #FILTER ON [ORDER=20]");
  CHECK(block("# FILTER ON", 5001) == "#FILTER ON");
  CHECK(block("#VIBGUARD ON [FREQ=40]", 5001) == "#VIB GUARD ON [FREQ=40]");
  CHECK(block("#VIB_GUARD ON", 5001) == "#VIB GUARD ON");
  CHECK(block("#vib  gard ON", 5001) == "#VIB GUARD ON");
  CHECK(block("#FILTERON[ORDER=20]", 5001) == "#FILTER ON[ORDER=20]");
  CHECK(block("#VIB GUARDON", 5001) == "#VIB GUARD ON");
  CHECK(block("#VIB_GUARD_OFF", 5001) == "#VIB GUARD OFF");
  CHECK(block("#SLOPE ON #HSC ON #FILE", 5001) == "no finding");
  CHECK(block("#FILTER ON OFF", 5001) == "none");
  CHECK(block("#FILTER on", 5001) == "#FILTER ON");
  CHECK(block("#FILTER ON [ORDER=20, SHARE=80]", 5001) == "#FILTER ON [ORDER=20 SHARE=80]");
  CHECK(block("#FILTER ON [AX_DEV=0,01]", 5001) == "#FILTER ON [AX_DEV=0.01]");
  CHECK(block("N1 #FILTER ON ORDER=20 SHARE=80 ; comment", 5001) ==
        "N1 #FILTER ON [ORDER=20 SHARE=80] ; comment");
  CHECK(block("#FILTER ON [AX DEV=0.01]", 5002) == "#FILTER ON [AX_DEV=0.01]");
  CHECK(block("#FILTER ON [AX DEV=0.01]", 5001) == "no finding");
}

TEST_CASE("times in milliseconds and frequencies in millihertz") {
  auto const helps = [](std::string const& name, std::string const& text, std::string const& wanted) {
    tests::MapFiles files(std::map<std::string, std::string>{{name, text}});
    SourceSet sources;
    validator::CheckOptions options;
    options.cycle_time = design::CycleTime{1'000'000};
    std::string all;
    for (Finding const& finding : validator::check(files, name, options, sources).findings) {
      for (Message const& help : finding.help) all += render(help, Language::english) + "\n";
    }
    return all.find(wanted) != std::string::npos;
  };
  std::string const fir = "filter_fir.type 1\nfilter_fir.enable 1\nfilter_fir.order_time ";
  CHECK(helps("x.lis", fir + "20", "20 ms are `filter_fir.order_time 20000`"));
  CHECK_FALSE(helps("x.lis", fir + "900", "ms are"));
  CHECK(helps("x.nc", "#FILTER ON [ORDER_TIME=20]", "20 ms are `ORDER_TIME=20000`"));
  CHECK_FALSE(helps("x.nc", "#FILTER ON [ORDER_TIME=900]", "ms are"));
  std::string const lowpass = "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 ";
  CHECK(helps("x.lis", lowpass + "17500", "17500 mHz are `filter[0].fg_f0 17.5`"));
  CHECK_FALSE(helps("x.lis", lowpass + "600", "mHz"));
  CHECK(helps("x.lis", "getriebe[0].dynamik.vb_max 1.500.000", "`1500000`"));
  CHECK(helps("x.lis", "kopf.mds_ident 4 0", "`40`"));
}

TEST_CASE("a guess does not keep a list from being compiled") {
  std::string const list =
      "kopf.achs_nr 1\nkopf.log_achs_name X\npath[0].type 3\nfir.type 1\nfilter.order 1\n";
  tests::MapFiles files(std::map<std::string, std::string>{{"x.lis", list}});
  SourceSet sources;
  validator::CheckOptions options;
  options.cycle_time = design::CycleTime{1'000'000};
  options.disabled = {Code{2002}};
  options.severities[Code{2001}] = Severity::warning;
  auto const result = validator::check(files, "x.lis", options, sources);
  CHECK(result.machine);
  CHECK(result.not_compiled.empty());
}

}  // namespace fixes_test
