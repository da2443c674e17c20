// Lines that are read without the grammar read the same with it.
#include "grammar/regular_lines.hpp"

#include "grammar/axis_list.hpp"
#include "support/catch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <rapidcheck.h>

namespace {

using namespace axisc::grammar;

/// Only where a block of text follows a line is it read without the grammar.
std::string with_room(std::string const& text) {
  return text + "\n" + std::string(70, '#') + "\n";
}

/// In every way that this processor can go; the others read by the grammar.
bool reads_alike_as_it_is(std::string const& text) {
  for (bool const windows_1252 : {false, true}) {
    auto const by_grammar = parse_axis_list(text, 0, windows_1252, Way::by_grammar);
    for (Way const way : {Way::quick, Way::portable, Way::avx2}) {
      if (parse_axis_list(text, 0, windows_1252, way) != by_grammar) return false;
    }
  }
  return true;
}

bool reads_alike(std::string const& text) {
  return reads_alike_as_it_is(text) && reads_alike_as_it_is(with_room(text));
}

rc::Gen<std::string> one_of(std::vector<std::string> const& texts) {
  return rc::gen::elementOf(texts);
}

/// Any number of pieces.
rc::Gen<std::string> joined(rc::Gen<std::string> const& piece) {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](auto const& pieces) {
    std::string text;
    for (std::string const& each : pieces) text += each;
    return text;
  });
}

/// Names, right and wrong in every bracket and point.
rc::Gen<std::string> name() {
  auto const piece =
      one_of({"a", "b7", "_", "filter", "[", "]", "[0]", "[12]", ".", ".x", "9", "-", "P-", "\xE4"});
  auto const usual =
      one_of({"filter[0].order", "kopf.achs_nr", "a[1].b[22].c", "ende", "Ende", "a[1[2]].b", "a[1]2].c",
              "a1].b[0", "antr.sercos.mdt[3].a_name_that_is_longer_than_usual_by_a_good_deal_of_letters"});
  return rc::gen::oneOf(usual, joined(piece));
}

rc::Gen<std::string> value() {
  auto const usual = one_of({"1",
                             "0",
                             "007",
                             "-5",
                             "+5",
                             "+",
                             "-",
                             "0x1F",
                             "0x",
                             "-0x1",
                             "0xG",
                             "1.5",
                             ".5",
                             "5.",
                             ".",
                             "-.5",
                             "00.5",
                             "1e5",
                             "1e+5",
                             "1e",
                             "1.e5",
                             "e5",
                             "1.5e-3",
                             "1e5x",
                             "1.2.3",
                             "1,8",
                             "LOWPASS",
                             "TRUE",
                             "P-AXIS-00212",
                             "P-AXIS-00212.0",
                             "P_1",
                             "\"quoted text\"",
                             "\"open",
                             "wo(rt",
                             "w\xC3\xA4",
                             "a\"b",
                             "%x",
                             "/path",
                             "/*",
                             "(",
                             "#",
                             "12abc",
                             "0X7f",
                             "1E5"});
  auto const piece =
      one_of({"1", "0", "7", ".", "e", "E", "x", "+", "-", "a", "F", "(", "\"", "\xC3\xA4", "/"});
  return rc::gen::oneOf(usual, joined(piece));
}

rc::Gen<std::string> trailer() {
  return one_of(
      {"", "", "( Kommentar", "(geschlossen) mehr", "# Zahl", "/* Stern */", "/ Strich", "5",
       "text \"mit\" (Quote", "( l\xE4nger", "( l\xC3\xA4nger", "( \xC2\x85", "( \x81",
       "( axisc: allow AX3005", "\x01",
       "( so lang, dass der Kommentar gewiss bis weit hinter das Ende eines Blocks reicht \xC3\xBC \"",
       "ohne Klammer, aber so lang, dass er gewiss bis weit hinter das Ende eines Blocks reicht (jetzt"});
}

rc::Gen<std::string> line() {
  auto const blanks = one_of({" ", "\t", "  ", "          ", std::string(40, ' '), std::string(60, ' '), ""});
  auto const line_end = one_of({"\n", "\r\n", " \n", "\t \r\n", "\r\r\n", "\r", ""});
  return rc::gen::map(rc::gen::tuple(one_of({"", "", "", " ", "\t", "#", "( "}), name(), blanks, value(),
                                     blanks, trailer(), line_end),
                      [](auto const& parts) {
                        return std::apply([](auto const&... part) { return (std::string() + ... + part); },
                                          parts);
                      });
}

TEST_CASE("regular lines read as the grammar reads them") {
  REQUIRE(rc::check("lines of all kinds", [] {
    std::string text;
    for (std::string const& each : *rc::gen::container<std::vector<std::string>>(line())) text += each;
    RC_ASSERT(reads_alike(text));
  }));
  REQUIRE(rc::check("any bytes", [](std::string const& text) { RC_ASSERT(reads_alike(text)); }));
}

TEST_CASE("every place of a token in its block reads alike") {
  for (std::size_t room = 0; room < 80; ++room) {
    std::string const blanks(room, ' ');
    CHECK(reads_alike("a" + blanks + " 1 ( b"));
    CHECK(reads_alike(blanks + "filter[0].order 1.5 text (b"));
    CHECK(reads_alike(blanks + "filter[0].order 0x1F" + blanks + "\"q\" # b"));
    CHECK(reads_alike("filter[0].order 1e5" + blanks + "\r\nx 1\n" + blanks + "\r\n" + blanks + "# b"));
    CHECK(reads_alike(std::string(room + 1, 'a') + " WORD(b"));
    CHECK(reads_alike("a " + std::string(room + 1, '1')));
  }
}

TEST_CASE("directives read alike near the end of the text and far from it") {
  for (std::size_t room = 0; room < 140; ++room) {
    CHECK(reads_alike_as_it_is("# axisc: allow AX3005\na 1\nb 2 ( axisc: allow AX3005\n" +
                               std::string(room, '#')));
    CHECK(reads_alike_as_it_is("a 1\n\nb 2\n#" + std::string(room, ' ') + "axisc: allow AX3005\n# x\nc 3"));
  }
}

TEST_CASE("many regular lines in a row read alike") {
  for (std::size_t const count : {31U, 32U, 33U, 64U, 65U}) {
    for (std::string const between : {"", "\n", "# b\n"}) {
      std::string text;
      for (std::size_t i = 0; i < count; ++i) text += between + "filter[0].order " + std::to_string(i) + "\n";
      CHECK(parse_axis_list(with_room(text), 0, false).assignments.size() == count);
      CHECK(reads_alike(text));
      CHECK(reads_alike(text + "a 1 # axisc: allow AX3005\nb 2\n"));
      CHECK(reads_alike(text + "Ende\nb 2\n"));
      CHECK(reads_alike(text + "a[ 1\nb 2\n"));
    }
  }
}

TEST_CASE("what stands far behind reads alike") {
  for (std::string const piece :
       {"(", "\"", "\x01", "\t", "\xC2\x85", "\xC3\xA4", "\x81", "\r", "\xE2\x82\xAC"}) {
    for (std::size_t place = 0; place < 300; ++place) {
      std::string const text = std::string(place, 'x') + piece + std::string(200, 'y') + "\n";
      if (!reads_alike("a 1 " + text) || !reads_alike("a w " + text) || !reads_alike("# " + text)) {
        CAPTURE(piece, place);
        CHECK(false);
      }
    }
  }
}

struct Read {
  std::size_t assignments = 0;
  std::size_t bytes = 0;
  std::uint32_t lines = 0;
};

Read read_directly(Way way, std::string const& text) {
  std::string const whole = text + std::string(room_behind_line, '#');
  RegularLines lines{.text = whole.data(),
                     .line = whole.data(),
                     .stop = whole.data() + text.size(),
                     .end = whole.data() + whole.size(),
                     .number = 0,
                     .windows_1252 = false};
  std::array<Assignment, 20> assignments;
  std::size_t const count = find_regular_line_reader(way)(lines, assignments.data(), assignments.size());
  return {.assignments = count,
          .bytes = static_cast<std::size_t>(lines.line - whole.data()),
          .lines = lines.number};
}

TEST_CASE("regular lines are read without the grammar, up to the first that is not") {
  std::string const regular =
      "\n  \n# Kommentar\nfilter[0].order 3\na.b -1.5\nc 0x1F ( d\ne LOWPASS\r\nf 1e5 # g\nh +7\n";
  for (Way const way : {Way::quick, Way::portable, Way::avx2}) {
    if (find_regular_line_reader(way) == nullptr) continue;
    Read const all = read_directly(way, regular);
    CHECK(all.assignments == 6);
    CHECK(all.lines == 9);
    CHECK(all.bytes == regular.size());
    for (std::string const irregular :
         {"Ende", "a \"b\"", "a P-AXIS-00212", "a[x] 1", "a 007", "a 1,8", "a", "\x01", "= 5"}) {
      CAPTURE(irregular);
      Read const some = read_directly(way, regular + irregular + "\nz 1\n");
      CHECK(some.assignments == 6);
      CHECK(some.bytes == regular.size());
    }
  }
  CHECK(find_regular_line_reader(Way::portable) != nullptr);
  CHECK(find_regular_line_reader(Way::by_grammar) == nullptr);
}

}  // namespace
