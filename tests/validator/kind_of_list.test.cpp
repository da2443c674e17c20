// Which lists are axis lists, and that nothing is said about the lines of others.
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"
#include "validator/list_layout.hpp"

#include <string>
#include <vector>

namespace {

using namespace axisc;

struct Outcome {
  std::vector<std::string> codes;
  bool is_other = false;
};

Outcome check(std::string const& text, validator::CheckOptions options = {}) {
  tests::MapFiles files({{"x.lis", text}});
  SourceSet sources;
  options.cycle_time = design::CycleTime{1'000'000};
  validator::CheckResult const result = validator::check(files, "x.lis", options, sources);
  Outcome outcome;
  outcome.is_other = result.is_other_list;
  for (Finding const& finding : result.findings) outcome.codes.push_back(code_text(finding.code));
  return outcome;
}

bool is_other(std::string const& text) {
  return check(text).is_other;
}

using Codes = std::vector<std::string>;

}  // namespace

TEST_CASE("a number in a comment tells the kind of a list") {
  CHECK(is_other("path[0].type 0x03 ( P-CHAN-00403\n"));
  CHECK(is_other("default_index 0 ( P-ZERO-00002\n"));
  CHECK(is_other("something 0 ( P-STUP-00001\nfilter[0].order 99\nelse 0 ( P-STUP-00002\n"));
  CHECK_FALSE(is_other("something 0 ( P-AXIS-00001\n"));
  CHECK_FALSE(is_other("something 0 ( P-CHAN- is no number\n"));
  CHECK_FALSE(is_other("something 0 ( P-ELSE-00001\n"));
}

TEST_CASE("typical names tell the kind of a list") {
  for (char const* const name :
       {"listen", "gruppe[0].achse[0].log_achs_nr", "windows_time", "hr_data[0].log_achs_nr", "wz[1].laenge",
        "np_grp[0].x", "pzv_grp[0].x", "kw.x[0]", "var[0].name", "gobject[0].x", "ddl[0].x"}) {
    INFO(name);
    CHECK(is_other(std::string(name) + " 1\n"));
  }
}

TEST_CASE("an axis list with a few foreign names stays one") {
  CHECK_FALSE(is_other("kopf.achs_nr 1\nkopf.log_achs_name X\npath[0].type 3\n"));
  CHECK_FALSE(is_other("kenngr.achs_typ 1\nwz[1].laenge 1\n"));
  CHECK_FALSE(is_other(""));
  CHECK_FALSE(is_other("hugo.egon 5\n"));
  // The head of a compensation list is that of an axis list.
  CHECK(is_other("kopf.achs_nr 1\nkopf.mds_ident 1\nkw.x[0] 1\n"));
  // Families that channel lists have too.
  CHECK(is_other("trafo[0].id 1\nerror_filter[0].reason 1\ngrp_anzahl 1\n"));
}

TEST_CASE("a list of another kind is checked with the catalogue of its kind, and aligned where it is named") {
  std::string const list = "wz[1].laenge 1,5\nwz[12].gueltig 7\nwz[3].radius x\n";
  CHECK(check(list).codes == Codes{"AX1005", "AX2003", "AX2003"});
  SourceText const source("x.lis", list);
  CHECK(validator::aligned_list(source, {}, validator::AlignedKinds::axis) == list);
  CHECK(validator::aligned_list(source) == "wz[1].laenge    1,5\nwz[12].gueltig  7\nwz[3].radius    x\n");
}

TEST_CASE("a machine needs axis lists") {
  tests::MapFiles files({{"m.json", R"({"cycle_time_us":1000,"axes":[{"name":"X","list":"wz.lis"}]})"},
                         {"wz.lis", "wz[1].laenge 1\n"}});
  SourceSet sources;
  auto const result = validator::check(files, "m.json", {}, sources);
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings.front().code == Code{7009});
  CHECK(result.findings.front().severity == Severity::error);
  CHECK_FALSE(result.machine);
}

TEST_CASE("a list in a folder that says nothing about its kind is not checked") {
  validator::CheckOptions options;
  options.from_folder = true;
  for (std::string const text : {"", "hugo.egon 1,5\n", "kopf.nix 5\nanzahl [\n"}) {
    INFO(text);
    Outcome const outcome = check(text, options);
    CHECK(outcome.codes == Codes{"AX7001"});
    CHECK(outcome.is_other);
  }
  CHECK(check("kopf.achs_nr 1\nkenngr.achs_typ 1\n", options).codes.empty());
}

TEST_CASE("a list in a folder is of the kind that its comments number, whatever its lines are like") {
  validator::CheckOptions options;
  options.from_folder = true;
  CHECK(check("# P-AXIS-00140\nfilter[0],order=1\n", options).codes == Codes{"AX1002"});
  CHECK(check("filter[0],order=1 ( P-AXIS-00140\n", options).codes == Codes{"AX1002"});
  Outcome const tools = check("# P-TOOL-00003\nwz[1],laenge=1\n", options);
  CHECK(tools.is_other);
  CHECK(tools.codes != Codes{"AX7001"});
}

TEST_CASE("who is asked to take a list for a kind does so") {
  validator::CheckOptions options;
  options.kind = schema::ListKind::channel;
  CHECK(check("kenngr.achs_typ 1\ngruppe[0].achs_anzahl x\n", options).codes == Codes{"AX2003"});
  options.kind = schema::ListKind::axis;
  CHECK_FALSE(check("gruppe[0].achs_anzahl 1\n", options).is_other);
}

TEST_CASE("only names of another kind of list are mended, and catalogues that know less warn") {
  std::string const list =
      "gruppe[0].achs_anzal 2\ngruppe[0].bezeichnung A\nh_synch[0] mos\nh_synch[0] MOS\n"
      "thread[0].cpu 3 ( P-CHAN-09999\nspdl_anzahl -1\n";
  tests::MapFiles files({{"x.lis", list}});
  SourceSet sources;
  validator::CheckOptions options;
  options.pedantic = true;
  struct Said {
    std::string code;
    Severity severity{};
    bool has_fix = false;
    bool operator==(Said const&) const = default;
  };
  std::vector<Said> said;
  for (Finding const& finding : validator::check(files, "x.lis", options, sources).findings) {
    said.push_back({code_text(finding.code), finding.severity, finding.fix.has_value()});
  }
  CHECK(said == std::vector<Said>{{"AX2001", Severity::warning, true},
                                  {"AX1010", Severity::warning, false},
                                  {"AX2001", Severity::note, false},
                                  {"AX2004", Severity::warning, false}});
}

TEST_CASE("values of other lists are words that are joined, words with digits, lists of numbers and paths") {
  std::string const list =
      "sercos_lwl_baudrate[0]       2MBAUD\n"
      "error_protocol_mode          REPORT | REPORT_EXTENDED |PRINT   ( comment\n"
      "error_filter[0].reason       20804,20805,21209\n"
      "configuration.channel[0].decoder.function  FCT_DEFAULT | FCT_NO_DISPLAY\n"
      "digital_driver_adr           0xD0000\n"
      "history_filename             C:\\temp\\x.hist   ( comment\n"
      "mds_time_slots               2   # comment\n";
  validator::CheckOptions options;
  options.pedantic = true;
  options.kind = schema::ListKind::startup;
  CHECK(check(list, options).codes == Codes{});
  // A misspelt word is a warning, alone or joined with others; one that nobody knows is a note.
  CHECK(check("error_protocol_mode REPORT | REPROT\n", options).codes == Codes{"AX2007"});
  options.pedantic = false;
  CHECK(check("error_protocol_mode REPORT | REPROT\n", options).codes == Codes{"AX2007"});
  CHECK(check("error_protocol_mode REPORT | HUGO_EGON_7\n", options).codes == Codes{});
}
