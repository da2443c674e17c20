#include "cli/program.hpp"
#include "schema/motion_words.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace explain_test {

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
    CHECK(outcome.err == "axisc: error: nothing is found for \"" + word + "\"" + expected + "\n");
  };
  check("50999", "; did you mean 50989?");
  std::string const knows =
      ": `axisc explain` knows codes, messages of the control, parameters, words of NC programs and what "
      "they "
      "mean; `axisc explain --all` lists the codes";
  check("foo", knows);
  check("P-AXIS-99999", knows);
  CHECK(run_axisc({"explain"}).status == 2);
}

TEST_CASE("a typing error is read, and the page says so") {
  auto const first_lines = [](std::string const& word) {
    auto const page = run_axisc({"explain", word}).out;
    return page.substr(0, page.find('\n', page.find("read as")));
  };
  CHECK(first_lines("filter[0].odrer") ==
        "# filter[].order (P-AXIS-00140)\n\n\"filter[0].odrer\" was read as \"filter[0].order\".");
  CHECK(first_lines("dely-too-long") ==
        "# AX3005 delay-too-long\n\n\"dely-too-long\" was read as \"Delay too long\".");
}

TEST_CASE("people's words, topics and messages in both languages and every format") {
  for (std::string const language : {"en", "de"}) {
    auto const golden = [&](std::string const& name, std::vector<std::string> arguments) {
      arguments.insert(arguments.begin(), "explain");
      arguments.insert(arguments.end(), {"--lang", language});
      auto const outcome = run_axisc(arguments);
      CHECK(outcome.status == 0);
      check_golden("tests/cli/data/golden/look_up/" + name + "." + language, outcome.out);
    };
    golden("message", {"Fehler", "50663"});
    golden("message.json", {"P-ERR-50663", "--format", "json"});
    golden("undocumented", {"21411", "--format", "text"});
    golden("topic", {"Kerbfilter"});
    golden("topic.json", {"#FILTER", "--format", "json"});
    golden("list", {"Endschalter", "--format", "text"});
    golden("list.csv", {"Endschalter", "--format", "csv"});
  }
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

TEST_CASE("a parameter's page says what it and its values mean") {
  auto const page = [](std::string const& name, std::string const& language = "en") {
    return run_axisc({"explain", name, "--lang", language}).out;
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(page("filter_fir.type"), Contains("| 2 | Gaussian |\n"));
  CHECK_THAT(page("filter_fir.type", "de"), Contains("| 2 | Gau\xC3\x9F |\n"));
  CHECK_THAT(page("kenngr.achs_mode"), Contains("| 0x10000 | gantry master |\n") && Contains("default: 1\n"));
  CHECK_THAT(page("kenngr.antr_typ"), Contains("| 8 | CANopen") && Contains("default: 4\n"));
  CHECK_THAT(page("filter[0].fg_f0"),
             Contains("0 < value < 0.5/T (500 Hz at T = 1 ms)") && Contains("default: 30\n"));
  CHECK_THAT(page("filter[0].time_constant"), Contains("| PT1, PT2 | T \xE2\x89\xA4 value |\n") &&
                                                  Contains("| TIME_DELAY | 0 \xE2\x89\xA4 value < 6 T |\n"));
  CHECK_THAT(page("getriebe[0].dynamik.a_trans_weight"),
             Contains("1 \xE2\x89\xA4 value \xE2\x89\xA4 1000, or 0\n"));
  CHECK_THAT(
      page("getriebe[0].dynamik.vb_max"),
      Contains("\xC2\xB5m/s (translatory), 0.001 \xC2\xB0/s (rotary)") && Contains("200000 (200 mm/s)"));
  CHECK_THAT(page("getriebe[0].dynamik.vb_max", "de"), Contains("0,001 \xC2\xB0/s (rotatorisch)"));
  CHECK_THAT(page("antr.generic.address"), Contains("the manuals do not describe this parameter"));
}

TEST_CASE("a parameter's page names the rules that look at its value") {
  auto const rules = [](std::string const& name) {
    auto const json = nlohmann::json::parse(run_axisc({"explain", name, "--format", "json"}).out);
    return json["parameters"][0]["rules"].get<std::vector<std::string>>();
  };
  auto const has = [&](std::string const& name, std::string const& code) {
    auto const codes = rules(name);
    return std::find(codes.begin(), codes.end(), code) != codes.end();
  };
  CHECK(has("filter[0].share_percent", "AX3015"));
  CHECK(has("filter[0].share_percent", "AX3017"));
  CHECK(has("filter_fir.share", "AX3015"));
  CHECK(has("filter[0].fg_f0", "AX3003"));
  CHECK_FALSE(has("filter[0].fg_f0", "AX1011"));
  CHECK(has("filter[0].order", "AX3007"));
  CHECK(has("filter[0].order", "AX3008"));
  CHECK_FALSE(has("filter[0].order", "AX1003"));
  CHECK(has("kopf.achs_nr", "AX4015"));
  CHECK_FALSE(has("kopf.achs_nr", "AX1002"));
  CHECK(has("getriebe[0].dynamik.vb_max", "AX2015"));
}

TEST_CASE("a message of the control is explained by the findings that foretell it") {
  auto const english = run_axisc({"explain", "50557"});
  CHECK(english.status == 0);
  CHECK_THAT(english.out, Catch::Matchers::StartsWith("# Message 50557 of the control\n") &&
                              Catch::Matchers::Contains("\n| AX3002 | frequency-above-nyquist | "));
  CHECK(run_axisc({"explain", "Fehler", "50557"}).out == english.out);
  auto const json = nlohmann::json::parse(run_axisc({"explain", "50557", "--format", "json"}).out);
  CHECK(json["rules"][0]["code"] == "AX3002");
  // Both a code and a message.
  CHECK_THAT(run_axisc({"explain", "2009"}).out,
             Catch::Matchers::Contains("\n## AX2009 ") &&
                 Catch::Matchers::Contains("\n## Message 2009 of the control"));
}

TEST_CASE("a part of a name lists the parameters that contain it") {
  auto const outcome = run_axisc({"explain", "VB_max"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("| getriebe[].dynamik.vb_max | P-AXIS-00212 | "));
  CHECK(lines_of(run_axisc({"explain", "filter_fir", "--format", "csv"}).out) == 8);
  CHECK_THAT(run_axisc({"explain", "lose", "--lang", "de"}).out,
             Catch::Matchers::StartsWith("# getriebe[].lose (P-AXIS-00103)\n"));
  CHECK_THAT(run_axisc({"explain", "gaussian"}).out, Catch::Matchers::Contains("| filter_fir.quality |"));
}

TEST_CASE("parameters of other kinds of lists are explained by their numbers, names and parts of names") {
  auto const by_number = run_axisc({"explain", "P-CHAN-00035"});
  CHECK(by_number.status == 0);
  check_golden("tests/cli/data/golden/explain.en.channel", by_number.out);
  CHECK(run_axisc({"explain", "gruppe[0].achse[3].log_achs_nr"}).out == by_number.out);
  CHECK(run_axisc({"explain", "p-chan-35"}).out == by_number.out);
  check_golden("tests/cli/data/golden/explain.de.channel",
               run_axisc({"explain", "P-CHAN-00035", "--lang", "de"}).out);
  CHECK_THAT(run_axisc({"explain", "koppel_gruppe"}).out, Catch::Matchers::Contains("P-CHAN-00038"));
  // A name of axis lists means theirs, although compensation lists have it too.
  CHECK_THAT(run_axisc({"explain", "kopf.achs_nr"}).out, Catch::Matchers::Contains("P-AXIS-00016"));
  auto const json = nlohmann::json::parse(run_axisc({"explain", "P-STUP-00015", "--format", "json"}).out);
  CHECK(json["parameters"][0]["list"] == "startup");
  CHECK(json["parameters"][0]["p_axis"] == "P-STUP-00015");
}

TEST_CASE("a word of NC programs that says how a path is driven is explained") {
  check_golden("tests/cli/data/golden/words/en", run_axisc({"explain", "G60"}).out);
  check_golden("tests/cli/data/golden/words/de", run_axisc({"explain", "#SLOPE", "--lang", "de"}).out);
  check_golden("tests/cli/data/golden/words/json", run_axisc({"explain", "g131=50", "--format", "json"}).out);
  CHECK(run_axisc({"explain", "#slope [type=trapez]"}).out == run_axisc({"explain", "#SLOPE"}).out);
  for (auto const& word : axisc::schema::motion_words()) {
    auto const outcome = run_axisc({"explain", std::string(word.word)});
    INFO(word.word);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Catch::Matchers::Contains("`" + std::string(word.form) + "`"));
  }
}

TEST_CASE("the page about NC programs has a row for every word that says how a path is driven") {
  std::string const begin = "<!-- words: written by the tests -->\n";
  std::string const end = "<!-- end of words -->\n";
  std::string const name = "docs/nc-programs.md";
  auto page = read_source_file(name);
  auto const from = page.find(begin);
  auto const to = page.find(end);
  REQUIRE(from != std::string::npos);
  REQUIRE(to != std::string::npos);
  std::string table = "| word | counts | in plans | meaning | source |\n|---|---|---|---|---|\n";
  for (auto const& word : axisc::schema::motion_words()) {
    using axisc::schema::WordReach;
    using axisc::schema::WordUse;
    std::string form(word.form);
    for (std::size_t bar = form.find('|'); bar != std::string::npos; bar = form.find('|', bar + 2)) {
      form.insert(bar, "\\");
    }
    table += "| `" + form + "` | " + (word.reach == WordReach::block ? "in its block" : "from here on") +
             " | " +
             (word.use == WordUse::computed   ? "computed"
              : word.use == WordUse::accepted ? "no effect"
                                              : "refused") +
             " | " + std::string(word.meaning.in(axisc::Language::english)) + " | " +
             (word.source.empty() ? "" : "[page](" + axisc::schema::address_of(word.source) + ")") + " |\n";
  }
  page.replace(from + begin.size(), to - from - begin.size(), table);
  check_golden(name, page);
}

}  // namespace explain_test
