// Since when there is a rule, where its contents come from, and where it is silent on purpose.
#include "validator/engine/rule_facts.hpp"

#include "schema/catalogue.hpp"
#include "schema/motion_words.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/golden.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

using namespace axisc;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using validator::facts;
using validator::Rule;
using validator::RuleFacts;
using validator::rules;

namespace {

RuleFacts const& facts_of(std::uint16_t code) {
  return facts(*validator::find_rule(Code{code}));
}

std::string_view last_word(std::string_view source) {
  return source.substr(source.find_last_of(' ') + 1);
}

/// The number in P-AXIS-00513.
std::uint16_t number_in(std::string_view text) {
  std::uint16_t number = 0;
  auto const digits = text.substr(text.find_last_of('-') + 1);
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// A number of a message, a parameter of axis or channel lists, or a word of NC programs.
bool is_about_something(std::string_view about) {
  if (about.starts_with("P-AXIS-")) return !schema::Catalogue().find_number(number_in(about)).empty();
  if (about.starts_with("P-STUP-") || about.starts_with("P-CHAN-")) return number_in(about) > 0;
  if (about.starts_with('G')) return schema::find_motion_word(about) != nullptr;
  return about.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Sentences end with a full stop, which has a blank or nothing after it.
std::size_t sentences_of(std::string_view text) {
  std::size_t count = 1;
  for (auto at = text.find(". "); at != std::string_view::npos; at = text.find(". ", at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("every rule says in which version it came") {
  auto const changes = test::read_source_file("CHANGELOG.md");
  for (Rule const& rule : rules()) {
    auto const since = facts(rule).since;
    INFO(rule.name << " " << since);
    auto const heading = since == "unreleased" ? "## Unreleased\n" : "## " + std::string(since) + " (";
    CHECK_THAT(changes, Contains("\n" + heading));
  }
  // As the changes of the versions tell.
  CHECK(facts_of(3005).since == "0.1.0");
  CHECK(facts_of(4021).since == "0.2.0");
  CHECK(facts_of(7002).since == "0.2.0");
}

TEST_CASE("every rule has a source, or says why there is none") {
  for (Rule const& rule : rules()) {
    auto const& known = facts(rule);
    INFO(rule.name);
    CHECK((!known.sources.empty() || !known.own.english.empty()));
    // Without a source nothing can be read into one.
    if (known.sources.empty()) CHECK(known.reading.english.empty());
    std::set<std::string_view> const different(known.sources.begin(), known.sources.end());
    CHECK(different.size() == known.sources.size());
    for (auto const source : known.sources) {
      INFO(source);
      CHECK_FALSE(validator::source_text(source).empty());
      bool const has_label =
          source.find('/') != std::string_view::npos && source.find(' ') != std::string_view::npos;
      if (has_label) CHECK(is_about_something(last_word(source)));
    }
  }
}

TEST_CASE("every text about a rule is there in both languages, as one or two sentences") {
  for (Rule const& rule : rules()) {
    auto const& known = facts(rule);
    for (auto const* const text : {&known.reading, &known.own, &known.exceptions}) {
      INFO(rule.name << " " << text->english);
      CHECK(text->english.empty() == text->german.empty());
      if (text->english.empty()) continue;
      CHECK_THAT(std::string(text->english), EndsWith("."));
      CHECK_THAT(std::string(text->german), EndsWith("."));
      CHECK(text->english != text->german);
      CHECK(sentences_of(text->english) <= 2);
      CHECK(sentences_of(text->german) <= 2);
      CHECK(text->english.size() <= 300);
      CHECK(text->german.size() <= 300);
    }
  }
}

TEST_CASE("a source is said in words") {
  auto const check = [](std::string_view source, std::string_view english, std::string_view german) {
    auto const text = validator::source_text(source);
    CHECK(text.in(Language::english) == english);
    CHECK(text.in(Language::german) == german);
  };
  check("axis-filters 2.1.8", "Axis filters, section 2.1.8", "Achsfilter, Abschnitt 2.1.8");
  check("message 110583", "text of message 110583", "Text der Meldung 110583");
  check("tf5200_diagnosis/258487947 50663",
        "message 50663: https://infosys.beckhoff.com/content/1033/tf5200_diagnosis/258487947.html",
        "Meldung 50663: https://infosys.beckhoff.com/content/1033/tf5200_diagnosis/258487947.html");
  check("tf5200_axis_parameter/117579275 P-AXIS-00513",
        "P-AXIS-00513: https://infosys.beckhoff.com/content/1033/tf5200_axis_parameter/117579275.html",
        "P-AXIS-00513: https://infosys.beckhoff.com/content/1033/tf5200_axis_parameter/117579275.html");
  check("vendor-lists", "lists that the vendor ships", "Listen, die der Hersteller mitliefert");
  for (std::string_view const unknown : {"", "axis-filters", "invented 3.1", "invented/1", "message x"}) {
    CHECK(validator::source_text(unknown).empty());
  }
}

// The manuals are not part of the project.
TEST_CASE("the sections that rules cite are in the manuals") {
  struct Manual {
    std::string_view key;
    std::string_view file;
  };
  constexpr std::array manuals{Manual{"axis-filters", "axis-filters.de.txt"},
                               Manual{"fir-filters", "fir-filters.en.txt"},
                               Manual{"position-control", "improved-position-control.de.txt"}};
  auto const folder = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/manuals";
  for (auto const& manual : manuals) {
    if (!std::filesystem::exists(folder / manual.file)) {
      WARN("the manuals are not there: " << folder.string());
      return;
    }
    auto const text = test::file_contents(folder / manual.file);
    for (Rule const& rule : rules()) {
      for (auto const source : facts(rule).sources) {
        if (!source.starts_with(std::string(manual.key) + " ")) continue;
        INFO(rule.name << " " << source);
        CHECK_THAT(text, Contains("\n" + std::string(last_word(source)) + " "));
      }
    }
  }
}
