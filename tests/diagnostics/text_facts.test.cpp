#include "diagnostics/writers/writers.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace axisc;

TEST_CASE("facts about a run, in both languages") {
  RunFacts run;
  CHECK(write_text_facts(run, {}).empty());
  run.fixes = FixFacts{.applied = 1, .left_out = 2};
  run.baseline = BaselineFacts{
      .hidden = 3,
      .stale = {{.file = "x.lis", .axis = "X", .parameter = "filter[0].order", .code = Code{3005}}}};
  CHECK(write_text_facts(run, {}) ==
        "note: 1 finding was fixed\n"
        "note: 2 fixes were left out: they would lead to other findings\n"
        "note: 3 findings are hidden by the baseline\n"
        "note: the baseline holds AX3005 in x.lis X filter[0].order, which is not found any more\n");
  CHECK(write_text_facts(run, {.language = Language::german}) ==
        "Hinweis: 1 Befund wurde korrigiert\n"
        "Hinweis: 2 Korrekturen wurden ausgelassen: sie würden zu anderen Befunden führen\n"
        "Hinweis: 3 Befunde sind durch die Baseline ausgeblendet\n"
        "Hinweis: die Baseline enthält AX3005 in x.lis X filter[0].order, das nicht mehr gefunden wird\n");
}

TEST_CASE("a baseline that fits nothing does not flood the summary") {
  RunFacts run;
  run.baseline = BaselineFacts{};
  run.baseline->stale.resize(30, {.file = "x.lis", .axis = "", .parameter = "", .code = Code{1002}});
  std::string const text = write_text_facts(run, {});
  CHECK(std::count(text.begin(), text.end(), '\n') == 11);
  CHECK_THAT(text,
             Catch::Matchers::Contains("holds AX1002 in x.lis, which") &&
                 Catch::Matchers::EndsWith("20 further entries of the baseline are not found any more\n"));
}

TEST_CASE("statistics are a table") {
  CHECK(write_text_statistics({{.code = Code{3005}, .name = "delay-too-long", .count = 10, .fixable = 0},
                               {.code = Code{1005}, .name = "decimal-comma", .count = 2, .fixable = 1}},
                              {}) ==
        "10  AX3005  delay-too-long\n"
        " 2  AX1005  decimal-comma   1 with a fix\n");
}
