#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "validator/engine/rule.hpp"

#include <nlohmann/json.hpp>

using namespace axisc::test;

TEST_CASE("a code is explained by code, number or name, in both languages") {
  auto const english = run_axisc({"explain", "AX9006"});
  CHECK(english.status == 0);
  check_golden("tests/cli/data/golden/explain.en.code", english.out);
  check_golden("tests/cli/data/golden/explain.de.code", run_axisc({"explain", "AX9006", "--lang", "de"}).out);
  for (std::string const word : {"ax9006", "9006", "cycle-time-assumed"})
    CHECK(run_axisc({"explain", word}).out == english.out);
}

TEST_CASE("a parameter is explained by number or name") {
  auto const by_number = run_axisc({"explain", "P-AXIS-00140"});
  CHECK(by_number.status == 0);
  CHECK_THAT(by_number.out, Catch::Matchers::StartsWith("# filter[].order (P-AXIS-00140)\n"));
  CHECK_THAT(by_number.out, Catch::Matchers::Contains("`filter[0].order` to `filter[2].order`"));
  for (std::string const word : {"p-axis-140", "filter[2].order", "filter[].order", "filter[7].order"}) {
    CHECK(run_axisc({"explain", word}).out == by_number.out);
  }
  for (std::string const language : {"en", "de"}) {
    for (std::string const subject : {"AX3005", "filter[].type"}) {
      auto const json = run_axisc({"explain", subject, "--lang", language, "--format", "json"});
      check_golden("tests/cli/data/golden/explain." + language +
                       (subject == "AX3005" ? ".code" : ".parameter") + ".json",
                   json.out);
    }
  }
  check_golden("tests/cli/data/golden/explain.en.parameter", run_axisc({"explain", "kenngr.achs_typ"}).out);
  check_golden("tests/cli/data/golden/explain.de.parameter",
               run_axisc({"explain", "kenngr.achs_typ", "--lang", "de"}).out);
}

TEST_CASE("every code can be explained") {
  for (auto const& rule : axisc::validator::rules()) {
    auto const outcome = run_axisc({"explain", std::string(rule.name)});
    INFO(rule.name);
    CHECK(outcome.status == 0);
    CHECK(lines_of(outcome.out) > 4);
  }
}

TEST_CASE("an unknown word is met with a suggestion") {
  auto const check = [](std::string const& word, std::string const& expected) {
    auto const outcome = run_axisc({"explain", word});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err ==
          "axisc: error: \"" + word + "\" is neither a code nor a parameter; " + expected + "\n");
  };
  check("filter[0].odrer", "did you mean filter[0].order?");
  check("delay-to-long", "did you mean delay-too-long?");
  check("P-AXIS-99999", "`axisc explain --all` lists the codes");
  CHECK(run_axisc({"explain"}).status == 2);
}

TEST_CASE("docs/rules.md is what the program prints") {
  check_golden("docs/rules.md", run_axisc({"explain", "--all"}).out);
}

TEST_CASE("rules and parameters as JSON") {
  auto const parameter =
      nlohmann::json::parse(run_axisc({"explain", "filter_fir.order", "--format", "json"}).out);
  REQUIRE(parameter["parameters"].size() == 1);
  auto const& facts = parameter["parameters"][0];
  CHECK(facts["p_axis"] == "P-AXIS-00587");
  CHECK(facts["type"] == "UNS32");
  CHECK(facts["default"] == "0");
  CHECK(facts["since"] == "V3.1.3075.00");
  CHECK(facts["manual"] == "FIR filters, section 6.2");
  CHECK(parameter["rules"].empty());
  auto const rule = nlohmann::json::parse(run_axisc({"explain", "AX3005", "--format", "json"}).out);
  REQUIRE(rule["rules"].size() == 1);
  CHECK(rule["rules"][0]["name"] == "delay-too-long");
  CHECK(rule["rules"][0]["severity"] == "error");
  auto const all = nlohmann::json::parse(run_axisc({"explain", "--all", "--format", "json"}).out);
  CHECK(all["rules"].size() > 90);
  CHECK(all["parameters"].size() > 780);
}
