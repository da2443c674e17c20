#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace diff_test {

using namespace axisc::test;

namespace {

/// Two versions of a machine with one axis.
Surroundings two_machines(TemporaryFolder const& folder) {
  folder.write("old.lis",
               "filter[0].enable 1\nfilter[0].type BANDSTOP\nfilter[0].order 2\nfilter[0].fg_f0 42\n"
               "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 20\nEnde\n");
  folder.write("new.lis",
               "filter[0].enable TRUE\nfilter[0].type 4\nfilter[0].order 2\nfilter[0].fg_f0 48.5\n"
               "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 0x28\nEnde\n");
  for (std::string const side : {"old", "new"}) {
    folder.write(
        side + ".json",
        R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": ")" + side + R"(.lis"}]})");
  }
  return in_folder(folder.path());
}

nlohmann::json as_json(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "diff");
  arguments.insert(arguments.end(), {"--format", "json"});
  return nlohmann::json::parse(run_axisc(arguments, there).out);
}

}  // namespace

TEST_CASE("what changed in every format and language", "[digits]") {
  TemporaryFolder const folder;
  auto const there = two_machines(folder);
  for (std::string const language : {"en", "de"}) {
    for (std::string const form : {"text", "markdown", "json"}) {
      auto const outcome =
          run_axisc({"diff", "old.json", "new.json", "--lang", language, "--format", form}, there);
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
      check_golden("tests/cli/data/golden/diff/lists." + language + "." + form, outcome.out);
    }
  }
}

TEST_CASE("another spelling is no change, another meaning is") {
  TemporaryFolder const folder;
  auto const there = two_machines(folder);
  auto const json = as_json(there, {"old.json", "new.json"});
  CHECK(json["equal"] == false);
  REQUIRE(json["axes"].size() == 1);
  auto const& changes = json["axes"][0]["parameters"];
  REQUIRE(changes.size() == 2);
  CHECK(changes[0]["name"] == "filter[0].fg_f0");
  CHECK(changes[0]["place_after"] == "new.lis:4");
  CHECK(changes[1]["name"] == "filter_fir.order");
  CHECK(changes[1]["after"] == "0x28");
}

TEST_CASE("a value that is left out falls back to its default") {
  TemporaryFolder const folder;
  folder.write("a.lis", "getriebe[0].dynamik.vb_max 200000\nfilter_fir.share 90\nEnde\n");
  folder.write("b.lis", "Ende\n");
  auto const json = as_json(in_folder(folder.path()), {"a.lis", "b.lis"});
  REQUIRE(json["axes"].size() == 1);
  // 200000 is vb_max's default, so that only the share means something else.
  REQUIRE(json["axes"][0]["parameters"].size() == 1);
  CHECK(json["axes"][0]["parameters"][0]["name"] == "filter_fir.share");
  CHECK(json["axes"][0]["parameters"][0]["after"].is_null());
  CHECK(json["axes"][0]["parameters"][0]["default"] == "100");
}

TEST_CASE("the corner of a moving average of order 40 at 1000 mm/min and 1 ms") {
  TemporaryFolder const folder;
  auto const there = two_machines(folder);
  auto const json = as_json(there, {"old.json", "new.json", "--feed", "1000"});
  folder.write("fir.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 40\nEnde\n");
  folder.write("none.lis", "Ende\n");
  auto const fir = as_json(there, {"none.lis", "fir.lis", "--cycle-time", "1ms"});
  auto const& after = fir["axes"][0]["after"];
  // e = v T h (h + 1)/(2 (2 h + 1)) with h = 20, and the contour's deviation is √2 e.
  double const e = 1e6 / 60 * 1e-3 * 20 * 21 / (2 * 41.0);
  CHECK(after["corner_deviation_um"].get<double>() == Approx(std::sqrt(2.0) * e).epsilon(0.002));
  CHECK(after["delay_ms"] == 20);
  CHECK(after["settling_ms"] == 40);
  CHECK(after["overshoot_percent"].get<double>() < 1e-9);
}

TEST_CASE("equal inputs differ in nothing, whatever they are") {
  TemporaryFolder const folder;
  auto const there = two_machines(folder);
  REQUIRE(run_axisc({"compile", "old.json", "-o", "old.axim", "--quiet"}, there).status == 0);
  for (std::vector<std::string> const& pair : {std::vector<std::string>{"old.json", "old.json"},
                                               {"old.json", "old.axim"},
                                               {"old.axim", "old.json"},
                                               {"old.axim", "old.axim"},
                                               {"old.lis", "old.lis"}}) {
    auto const outcome = run_axisc({"diff", pair[0], pair[1], "--exit-code"}, there);
    INFO(pair[0] + " " + pair[1]);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == pair[0] + " and " + pair[1] + " mean the same\n");
  }
  CHECK(run_axisc({"diff", "old.axim", "new.json", "--exit-code"}, there).status == 1);
}

TEST_CASE("what diff refuses") {
  TemporaryFolder const folder;
  auto const there = two_machines(folder);
  folder.write("wrong.lis", "filter[0].guete 3,0\n");
  auto const wrong = run_axisc({"diff", "old.lis", "wrong.lis"}, there);
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.err, Catch::Matchers::Contains("AX1005"));
  CHECK(run_axisc({"diff", "old.lis"}, there).status == 2);
  CHECK(run_axisc({"diff", "old.lis", "missing.lis"}, there).status == 2);
  CHECK(run_axisc({"diff", "old.lis", "new.lis", "--feed", "-3"}, there).status == 2);
}

TEST_CASE("a symbol without a number means the same in any letter case") {
  TemporaryFolder const folder;
  folder.write("a.lis", "antr.operation_mode DRiVE_dEFAULT\nEnde\n");
  folder.write("b.lis", "antr.operation_mode DRIVE_DEFAULT\nEnde\n");
  auto const outcome = run_axisc({"diff", "a.lis", "b.lis", "--cycle-time", "1ms"}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("mean the same"));
}

}  // namespace diff_test
