#include "diagnostics/text.hpp"

#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"
#include "example_findings.hpp"
#include "support/catch.hpp"

#include <optional>
#include <set>
#include <string>

using namespace axisc;
using axisc::test::say;

namespace {

// The names of a template's placeholders; nothing when its braces are not balanced, or stand for something else.
std::optional<std::set<std::string>> placeholders(std::string_view text) {
  std::set<std::string> names;
  for (std::size_t open = text.find_first_of("{}"); open != std::string_view::npos;
       open = text.find_first_of("{}")) {
    std::size_t const close = text.find('}', open);
    if (text[open] == '}' || close == std::string_view::npos) return std::nullopt;
    std::string const name(text.substr(open + 1, close - open - 1));
    if (name.empty() ||
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
      return std::nullopt;
    }
    names.insert(name);
    text.remove_prefix(close + 1);
  }
  return names;
}

std::vector<Text> all_texts() {
  std::vector<Text> texts;
  for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(Text::count_); ++i)
    texts.push_back(static_cast<Text>(i));
  return texts;
}

}  // namespace

TEST_CASE("every text stands in both languages and names the same placeholders") {
  for (Text const text : all_texts()) {
    std::string_view const english = text_template(text, Language::english);
    std::string_view const german = text_template(text, Language::german);
    INFO(text_key(text) << ": " << english << " | " << german);
    CHECK_FALSE(english.empty());
    CHECK_FALSE(german.empty());
    auto const in_english = placeholders(english);
    auto const in_german = placeholders(german);
    CHECK(in_english.has_value());
    CHECK(in_german.has_value());
    CHECK(in_english == in_german);
  }
}

TEST_CASE("every text is one line of well-formed UTF-8 without blanks around it") {
  for (Text const text : all_texts()) {
    // What the commands print about themselves may have several lines.
    bool const is_help = text_key(text).starts_with("cli_");
    for (Language const language : {Language::english, Language::german}) {
      std::string_view const sentence = text_template(text, language);
      INFO(text_key(text) << ": " << sentence);
      CHECK(valid_utf8_prefix(sentence) == sentence.size());
      CHECK((is_help || printable(sentence) == sentence));
      CHECK((sentence.empty() || (sentence.front() != ' ' && sentence.back() != ' ')));
    }
  }
}

TEST_CASE("texts print numbers and braces as they are given") {
  CHECK(render(say("12 ms"), Language::english) == "12 ms");
  CHECK(render(say("{text} {{ }}"), Language::german) == "{text} {{ }}");
  CHECK(render({.text = Text::control_message, .arguments = {{.name = "number", .value = "50663"}}},
               Language::german) == "Meldung 50663");
}

TEST_CASE("values are made printable where that is asked for") {
  Message const message{.text = Text::ax2001, .arguments = {{"name", "a\tb µ\x1b"}}};
  std::string text = "\t";
  append_rendered(text, message, Language::german, Values::printable);
  CHECK(text == "\tunbekannter Parameter `a␉b µ␛`");
  CHECK(render(message, Language::english) == "unknown parameter `a\tb µ\x1b`");
}

TEST_CASE("a placeholder without a value stays") {
  CHECK(render({.text = Text::fixed_placeholder, .arguments = {}}, Language::english) == "{text}");
  CHECK(render({.text = Text::fixed_placeholder, .arguments = {{.name = "other", .value = "1"}}},
               Language::english) == "{text}");
}

TEST_CASE("values stand where their placeholders stood") {
  Message const message{.text = Text::ax3001, .arguments = {{"order", "7"}, {"type", "LOWPASS"}}};
  std::string const sentence(text_template(Text::ax3001, Language::english));
  std::string const rendered = render(message, Language::english);
  CHECK(rendered.size() == sentence.size() - std::string("{order}{type}").size() + 8);
  CHECK(rendered.find_first_of("{}") == std::string::npos);
  CHECK(rendered.find('7') == sentence.find("{order}"));
  CHECK(render({.text = Text::ax3001, .arguments = {{"type", "{order}"}, {"order", "{type}"}}},
               Language::english)
            .find("{type}") == sentence.find("{order}"));
}

TEST_CASE("keys are the names of the enumeration") {
  CHECK(text_key(Text::fixed_placeholder) == "fixed_placeholder");
  CHECK(text_key(Text::summary_nothing) == "summary_nothing");
}
