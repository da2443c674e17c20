// A list inside another file: places are those of the file, edits change the list alone.
#include "diagnostics/fix_batch.hpp"
#include "support/catch.hpp"

namespace {

using namespace axisc;

std::string const file = "<a>\n<b><![CDATA[one\ntwo]]></b>\n<b><![CDATA[three]]></b>\n";

SourceText window(SourceText const& whole, std::string const& text) {
  auto const begin = static_cast<std::uint32_t>(whole.bytes().find(text));
  auto const end = begin + static_cast<std::uint32_t>(text.size());
  return {"f.xti", Window{.file = whole, .span = {.begin = begin, .end = end}}};
}

Fix replace(SourceId source, Span span, std::string text) {
  return {.title = {}, .edits = {{.place = {.source = source, .span = span}, .text = std::move(text)}}};
}

Span span_of(SourceText const& source, std::string_view text) {
  auto const begin = static_cast<std::uint32_t>(source.bytes().find(text));
  return {.begin = begin, .end = begin + static_cast<std::uint32_t>(text.size())};
}

}  // namespace

TEST_CASE("lines and columns of a window are those of its file") {
  SourceText const source = window(SourceText("f.xti", file), "one\ntwo");
  CHECK(source.list_bytes() == "one\ntwo");
  CHECK(source.position(source.text_begin()) == Position{.line = 2, .column = 13});
  CHECK(source.position(span_of(source, "two").begin) == Position{.line = 3, .column = 1});
  CHECK(source.slice(source.line_span(2)) == "one");
  CHECK(source.slice(source.shown_line(2)) == "<b><![CDATA[one");
  CHECK(source.slice(source.line_span(3)) == "two");
  CHECK(source.line_span(1).empty());
  CHECK(source.line_span(4).empty());
}

TEST_CASE("windows of one file are found in any order, several in a line and behind a mark, too") {
  SourceText const whole("f.xti", "\xEF\xBB\xBF<b>one</b><b>two</b>\n<b>three\nfour</b>");
  auto const shown = [&](std::string const& text) {
    SourceText const source = window(whole, text);
    return source.position(source.text_begin());
  };
  CHECK(shown("three") == Position{.line = 2, .column = 4});
  CHECK(shown("two") == Position{.line = 1, .column = 14});
  CHECK(shown("one") == Position{.line = 1, .column = 4});
  CHECK(shown("four") == Position{.line = 3, .column = 1});
}

TEST_CASE("edits of several windows give one file") {
  SourceText const whole("f.xti", file);
  SourceSet sources;
  SourceId const first = sources.add(window(whole, "one\ntwo"));
  SourceId const second = sources.add(window(whole, "three"));
  Fix const one = replace(first, span_of(sources[first], "two"), "2");
  Fix const two = replace(second, span_of(sources[second], "three"), "3 three");
  FixBatch batch(sources);
  CHECK(batch.add(two));
  CHECK(batch.add(one));
  auto const edited = batch.apply();
  REQUIRE(edited.size() == 1);
  CHECK(edited.front().bytes == "<a>\n<b><![CDATA[one\n2]]></b>\n<b><![CDATA[3 three]]></b>\n");
}

TEST_CASE("an edit that would end the CDATA section is refused") {
  SourceText const whole("f.xti", "<b><![CDATA[a]x>b]]></b>");
  SourceSet sources;
  SourceId const id = sources.add(window(whole, "a]x>b"));
  FixBatch batch(sources);
  Fix const inside = replace(id, span_of(sources[id], "b"), "]]>");
  Fix const together = replace(id, span_of(sources[id], "x"), "]");
  Fix const harmless = replace(id, span_of(sources[id], "x"), "y");
  CHECK_FALSE(batch.add(inside));
  CHECK_FALSE(batch.add(together));
  CHECK(batch.add(harmless));
}
