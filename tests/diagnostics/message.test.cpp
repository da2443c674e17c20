#include "diagnostics/message.hpp"

#include "example_findings.hpp"
#include "support/catch.hpp"

#include <string>

using namespace axisc;
using axisc::test::say;

namespace {

constexpr Sentence unknown{"unknown parameter `{name}`", "unbekannter Parameter `{name}`"};
constexpr Sentence order{"{type} does not know order {order}", "die Ordnung {order} kennt {type} nicht"};

}  // namespace

TEST_CASE("a sentence is said in the language that is asked for") {
  CHECK(unknown.in(Language::english) == "unknown parameter `{name}`");
  CHECK(SentenceRef(unknown).in(Language::german) == "unbekannter Parameter `{name}`");
  CHECK(SentenceRef(unknown) == unknown);
  CHECK_FALSE(SentenceRef(unknown) == order);
}

TEST_CASE("messages print numbers and braces as they are given") {
  CHECK(render(say("12 ms"), Language::english) == "12 ms");
  CHECK(render(say("{text} {{ }}"), Language::german) == "{text} {{ }}");
  CHECK(render({unknown, {{.name = "name", .value = "50663"}}}, Language::german) ==
        "unbekannter Parameter `50663`");
}

TEST_CASE("values are made printable where that is asked for") {
  Message const message{unknown, {{"name", "a\tb µ\x1b"}}};
  std::string text = "\t";
  append_rendered(text, message, Language::german, Values::printable);
  CHECK(text == "\tunbekannter Parameter `a␉b µ␛`");
  CHECK(render(message, Language::english, Values::as_given) == "unknown parameter `a\tb µ\x1b`");
}

TEST_CASE("a placeholder without a value stays") {
  CHECK(render({}, Language::english) == "{text}");
  CHECK(render({says::as_given}, Language::english) == "{text}");
  CHECK(render({says::as_given, {{.name = "other", .value = "1"}}}, Language::english) == "{text}");
}

TEST_CASE("values are where their placeholders were") {
  Message const message{order, {{"order", "7"}, {"type", "LOWPASS"}}};
  CHECK(render(message, Language::english) == "LOWPASS does not know order 7");
  CHECK(render(message, Language::german) == "die Ordnung 7 kennt LOWPASS nicht");
}

TEST_CASE("a value that looks like a placeholder is not filled again") {
  Message const message{order, {{"type", "{order}"}, {"order", "{type}"}}};
  CHECK(render(message, Language::english) == "{order} does not know order {type}");
}

TEST_CASE("numbers have the decimal sign of the reader's language, and in code spans that of lists") {
  Message const message{order, {{"order", Wording::number("0.5 mm")}, {"type", "1.5.lis"}}};
  CHECK(render(message, Language::english) == "1.5.lis does not know order 0.5 mm");
  CHECK(render(message, Language::german) == "die Ordnung 0,5 mm kennt 1.5.lis nicht");
  Message const code{unknown, {{"name", Wording::number("0.5")}}};
  CHECK(render(code, Language::german) == "unbekannter Parameter `0.5`");
}

TEST_CASE("a wording is put together in both languages") {
  Wording const range = "T = " + Wording::number("0.5") + " ms, " + Wording("none", "keine");
  CHECK(range.in(Language::english) == "T = 0.5 ms, none");
  CHECK(range.in(Language::german) == "T = 0,5 ms, keine");
  CHECK(range == "T = 0.5 ms, none");
  CHECK(Wording::number("1.2e-07, 3.").in(Language::german) == "1,2e-07, 3.");
}
