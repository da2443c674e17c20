#include "diagnostics/source_text.hpp"

#include "support/catch.hpp"

#include <random>
#include <string>
#include <vector>

using namespace axisc;

namespace {

SourceText source(std::string bytes) {
  return {"x.lis", std::move(bytes)};
}

std::uint32_t offset_of(SourceText const& text, std::string_view bytes) {
  return static_cast<std::uint32_t>(text.bytes().find(bytes));
}

Position at(std::uint32_t line, std::uint32_t column) {
  return {.line = line, .column = column};
}

}  // namespace

namespace axisc {
// Catch prints it when a check fails.
static std::ostream& operator<<(std::ostream& stream, Position position) {
  return stream << position.line << ':' << position.column;
}
}  // namespace axisc

TEST_CASE("the encoding is UTF-8 where the bytes allow it") {
  CHECK(source("").encoding() == Encoding::utf8);
  CHECK(source("filter[0].order 3\n").encoding() == Encoding::utf8);
  CHECK(source("# Güte\n").encoding() == Encoding::utf8);
  CHECK(source("\xEF\xBB\xBF# Güte\n").encoding() == Encoding::utf8_with_mark);
  CHECK(source("# G\xFCte\n").encoding() == Encoding::windows_1252);
  CHECK(source("# \xC0\xAF\n").encoding() == Encoding::windows_1252);
  CHECK(source("# \xED\xA0\x80\n").encoding() == Encoding::windows_1252);
}

TEST_CASE("the text begins behind a byte order mark") {
  CHECK(source("a").text_begin() == 0);
  CHECK(source("\xEF\xBB\xBF").text_begin() == 3);
  CHECK(source("\xEF\xBB\xBF"
               "a")
            .text_begin() == 3);
  CHECK(source("\xEF\xBB\xBFG\xFCte").text_begin() == 3);
}

TEST_CASE("lines end with LF or CRLF") {
  SourceText const text = source("one\r\ntwo\n\r\nfour\rstill four");
  REQUIRE(text.line_count() == 4);
  CHECK(text.slice(text.line_span(1)) == "one");
  CHECK(text.slice(text.line_span(2)) == "two");
  CHECK(text.slice(text.line_span(3)).empty());
  CHECK(text.slice(text.line_span(4)) == "four\rstill four");
}

TEST_CASE("the empty line behind the last line end counts") {
  CHECK(source("").line_count() == 1);
  CHECK(source("a").line_count() == 1);
  CHECK(source("a\n").line_count() == 2);
  CHECK(source("a\r\n").position(3) == at(2, 1));
}

TEST_CASE("a line that is not there is empty") {
  SourceText const text = source("a\nb");
  CHECK(text.line_span(0).empty());
  CHECK(text.line_span(3).empty());
}

TEST_CASE("the byte order mark belongs to no line") {
  SourceText const text = source("\xEF\xBB\xBFone\n");
  CHECK(text.slice(text.line_span(1)) == "one");
  CHECK(text.position(0) == at(1, 1));
  CHECK(text.position(3) == at(1, 1));
  CHECK(text.position(5) == at(1, 3));
}

TEST_CASE("columns count code points") {
  std::string const line = "\t# G\xFCte\t\xB5s\tvalue\r\n";
  SECTION("in windows-1252 each byte is one") {
    SourceText const text = source("first\r\n" + line);
    CHECK(text.position(offset_of(text, "value")) == at(2, 12));
  }
  SECTION("in UTF-8 each sequence is one") {
    SourceText const text = source("first\r\n\t# Güte\tµs\t€\t😀\tvalue\r\n");
    CHECK(text.position(offset_of(text, "value")) == at(2, 16));
    CHECK(text.position(offset_of(text, "😀")) == at(2, 14));
  }
  SECTION("a byte inside a character has the character's column") {
    SourceText const text = source("😀x");
    for (std::uint32_t offset = 0; offset < 4; ++offset) CHECK(text.position(offset) == at(1, 1));
    CHECK(text.position(4) == at(1, 2));
    CHECK(text.position(5) == at(1, 3));
    CHECK(text.position(99) == at(1, 3));
  }
  SECTION("a line end has the column behind the line") {
    SourceText const text = source("ab\r\ncd\n");
    CHECK(text.position(2) == at(1, 3));
    CHECK(text.position(3) == at(1, 4));
    CHECK(text.position(6) == at(2, 3));
    CHECK(text.position(7) == at(3, 1));
  }
}

TEST_CASE("positions agree with counting from the start") {
  std::mt19937 random(20240117);
  for (int round = 0; round < 200; ++round) {
    bool const is_utf8 = round % 2 == 0;
    std::string bytes;
    for (int i = 0; i < 60; ++i) {
      constexpr std::array<std::string_view, 7> pieces{"a", "\n", "\r\n", "\t", "ü", "€", "😀"};
      std::string_view const piece = pieces.at(random() % pieces.size());
      bytes += piece == "ü" && !is_utf8 ? std::string_view("\xFC") : piece;
    }
    SourceText const text = source(bytes);
    bool const is_single_byte = text.encoding() == Encoding::windows_1252;
    Position expected;
    for (std::uint32_t offset = 0; offset < bytes.size(); ++offset) {
      bool const is_inside = !is_single_byte && (static_cast<unsigned char>(bytes[offset]) & 0xC0U) == 0x80U;
      if (is_inside) continue;
      if (text.position(offset) != expected) FAIL("offset " << offset << " in round " << round);
      expected = bytes[offset] == '\n' ? at(expected.line + 1, 1) : at(expected.line, expected.column + 1);
    }
  }
}

TEST_CASE("bytes become UTF-8 whatever the source holds") {
  SourceText const single = source("G\xFCte 12 \xB5s \x80\x81");
  CHECK(single.utf8({.begin = 0, .end = 13}) == "Güte 12 µs €\xEF\xBF\xBD");
  CHECK(single.utf8({.begin = 1, .end = 2}) == "ü");
  SourceText const multi = source("Güte");
  CHECK(multi.utf8({.begin = 0, .end = 5}) == "Güte");
  CHECK(multi.utf8({.begin = 0, .end = 2}) == "G\xEF\xBF\xBD");
}

TEST_CASE("fixes are written in the encoding of the source") {
  SourceText const single = source("\xFC");
  CHECK(single.encode("Güte €") == "G\xFCte \x80");
  CHECK(single.encode("0 ≤ d 😀") == "0 ? d ?");
  CHECK(source("ü").encode("0 ≤ d") == "0 ≤ d");
  CHECK(source("plain").encode("Güte") == "Güte");
}

TEST_CASE("a set keeps its sources where they are") {
  SourceSet sources;
  SourceId const first = sources.add(source("first"));
  SourceText const* const address = &sources[first];
  for (int i = 0; i < 1000; ++i) static_cast<void>(sources.add(source("more")));
  CHECK(&sources[first] == address);
  CHECK(sources[first].bytes() == "first");
  CHECK(sources.size() == 1001);
}

TEST_CASE("positions do not depend on which was asked for before") {
  for (std::string const mark : {"", "\xEF\xBB\xBF"}) {
    std::string const bytes = mark + "a\n\nfilter[0].order 3 # Güte\r\n\tb\n";
    SourceText const asked_often = source(bytes);
    std::mt19937 random(5);
    for (int round = 0; round < 500; ++round) {
      auto const offset = static_cast<std::uint32_t>(random() % (bytes.size() + 2));
      CHECK(asked_often.position(offset) == source(bytes).position(offset));
    }
  }
}

TEST_CASE("lines of a long text are found in any order") {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    // Lines of all lengths, also many empty ones and none; some texts end with a line end.
    std::vector<std::string> lines;
    std::string bytes = round % 5 == 0 ? "\xEF\xBB\xBF" : "";
    for (std::size_t i = random() % 120; i > 0; --i) {
      bool const is_long = random() % 9 == 0;
      lines.emplace_back(is_long ? random() % 700 : random() % (round % 3 == 0 ? 3U : 40U), 'a');
      bytes += lines.back() + (random() % 2 == 0 ? "\n" : "\r\n");
    }
    lines.emplace_back(random() % 3 == 0 ? "end" : "");
    bytes += lines.back();
    SourceText const text = source(bytes);
    for (int question = 0; question < 300; ++question) {
      CAPTURE(round, question);
      auto const number = static_cast<std::uint32_t>(random() % (lines.size() + 3));
      bool const is_there = number >= 1 && number <= lines.size();
      Span const span = text.line_span(number);
      CHECK(text.slice(span) == (is_there ? lines[number - 1] : ""));
      if (!is_there) continue;
      std::uint32_t const inside =
          span.size() == 0 ? 0 : static_cast<std::uint32_t>(random() % (span.size() + 1));
      CHECK(text.position(span.begin + inside) == at(number, inside + 1));
    }
    CHECK(text.line_count() == lines.size());
  }
}

TEST_CASE("a span that cuts characters is well-formed all the same") {
  SourceText const text = source("aüb");
  CHECK(text.utf8({.begin = 2, .end = 4}) ==
        "\xEF\xBF\xBD"
        "b");
  CHECK(text.utf8({.begin = 0, .end = 2}) == "a\xEF\xBF\xBD");
  CHECK(text.utf8({.begin = 1, .end = 3}) == "ü");
}
