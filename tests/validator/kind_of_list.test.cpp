// Which lists are axis lists, and that nothing is said about the lines of others.
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"
#include "validator/list_layout.hpp"

#include <string>
#include <vector>

namespace {

using namespace axisc;

std::vector<std::string> codes_of(std::string const& text) {
  tests::MapFiles files({{"x.lis", text}});
  SourceSet sources;
  std::vector<std::string> codes;
  validator::CheckOptions options;
  options.cycle_time = design::CycleTime{1'000'000};
  for (Finding const& finding : validator::check(files, "x.lis", options, sources).findings) {
    codes.push_back(code_text(finding.code));
    if (finding.code == Code{7001}) CHECK_FALSE(finding.fix);
  }
  return codes;
}

bool is_other(std::string const& text) {
  return codes_of(text) == std::vector<std::string>{"AX7001"};
}

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

TEST_CASE("nothing else is said about a list of another kind, and nothing is aligned") {
  std::string const list = "wz[1].laenge   1,5\n( axisc: allow AX3005\nEnde\ntext\nwz[2] 1\n";
  CHECK(is_other(list));
  CHECK(validator::aligned_list(SourceText("x.lis", list)) == list);
}

TEST_CASE("a machine needs axis lists") {
  tests::MapFiles files({{"m.json", R"({"cycle_time_us":1000,"axes":[{"name":"X","list":"wz.lis"}]})"},
                         {"wz.lis", "wz[1].laenge 1\n"}});
  SourceSet sources;
  auto const result = validator::check(files, "m.json", {}, sources);
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings.front().code == Code{7001});
  CHECK(result.findings.front().severity == Severity::error);
  CHECK_FALSE(result.machine);
}
