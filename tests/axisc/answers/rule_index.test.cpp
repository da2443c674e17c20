// The index of the rules: by symptom, parameter, message of the control and code.
#include "axisc/answers/explain/explain_index.hpp"
#include "presentation/writers.hpp"
#include "support/catch.hpp"
#include "validator/engine/rule_facts.hpp"

#include <set>
#include <string>
#include <string_view>

using namespace axisc;
using Catch::Matchers::Contains;

namespace {

std::string const& index_page() {
  static auto const page = [] {
    presentation::Document document{
        .title = presentation::as_given("index"), .blocks = rule_index({}), .csv_table = {}};
    return write(document, presentation::Format::markdown, {.language = Language::english});
  }();
  return page;
}

/// The text between a heading and the next one of its level or above.
std::string part_of(std::string const& heading) {
  auto const& page = index_page();
  auto const begin = page.find("\n" + heading + "\n");
  REQUIRE(begin != std::string::npos);
  auto const text = page.substr(begin + heading.size() + 2);
  auto const end = text.find("\n## ");
  auto const next = heading.starts_with("### ") ? std::min(end, text.find("\n### ")) : end;
  return text.substr(0, next);
}

}  // namespace

TEST_CASE("every rule has a symptom, and every symptom is in the index") {
  std::set<std::string_view> used;
  for (auto const& rule : validator::rules()) {
    INFO(rule.name);
    auto const symptoms = validator::facts(rule).symptoms;
    CHECK_FALSE(symptoms.empty());
    for (auto const symptom : symptoms) {
      INFO(symptom);
      used.insert(symptom);
      auto const text = symptom_text(symptom);
      REQUIRE(text);
      CHECK(text_of(*text, Language::english) != text_of(*text, Language::german));
      auto const part = part_of("### " + text_of(*text, Language::english));
      CHECK_THAT(part, Contains("[" + code_text(rule.code) + "](#" + code_text(rule.code) + ")"));
    }
  }
  CHECK(used.size() == 14);
  CHECK_FALSE(symptom_text("invented"));
}

TEST_CASE("a parameter leads to the rules about it, a message to those that foretell it") {
  auto const parameters = part_of("## By parameter");
  CHECK_THAT(parameters, Contains("\n| filter_fir.order_time | P-AXIS-00591 | [AX3021](#AX3021) |"));
  // The next rules about the same parameter follow without its name.
  CHECK_THAT(parameters, Contains("\n|  |  | [AX3022](#AX3022) |"));
  auto const messages = part_of("## By message of the control");
  CHECK_THAT(messages,
             Contains("\n| 50663 | [AX3004](#AX3004) |") && Contains("\n| 110490 | [AX2005](#AX2005) |"));
  CHECK_THAT(part_of("## By code"), Contains("\n| [AX3005](#AX3005) | delay-too-long | error |"));
}
