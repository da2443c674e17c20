// Lines are found and cut at their blanks as by looking at one byte after the other.
#include "grammar/plain_lines.hpp"

#include "support/catch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

namespace plain_lines_test {

namespace {

using namespace axisc::grammar;

struct Found {
  std::uint32_t begin = 0;
  bool unusual = false;
  friend bool operator==(Found const&, Found const&) = default;
};

std::vector<Found> found_in(std::string_view text, std::uint32_t begin) {
  PlainLines lines;
  find_lines(text, begin, lines);
  std::vector<Found> found;
  for (std::size_t i = 0; i < lines.count; ++i)
    found.push_back({.begin = lines.begins[i], .unusual = lines.unusual[i]});
  return found;
}

bool is_unusual(std::string_view line, std::size_t at) {
  char const byte = line[at];
  if (byte == '\t') return false;
  if (byte == '\r') return at + 1 != line.size();
  return byte < ' ' || byte > '~' || byte == ':';
}

/// All lines in whole blocks with a byte behind them, and with a block behind their begin.
std::vector<Found> plainly_found(std::string_view text, std::size_t begin) {
  std::size_t const end = begin + (text.size() - begin - 1) / room_behind_line * room_behind_line;
  std::vector<Found> found;
  for (std::size_t at = begin; at + room_behind_line <= text.size();) {
    std::size_t const feed = text.find('\n', at);
    if (feed >= end) break;
    Found& line = found.emplace_back(Found{.begin = static_cast<std::uint32_t>(at)});
    for (std::size_t i = at; i < feed; ++i) line.unusual |= is_unusual(text.substr(at, feed - at), i - at);
    at = feed + 1;
  }
  return found;
}

rc::Gen<std::string> text_of(std::vector<std::string> const& pieces) {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces)),
                      [](auto const& chosen) {
                        std::string text;
                        for (std::string const& each : chosen) text += each;
                        return text;
                      });
}

TEST_CASE("lines are found with their unusual bytes") {
  REQUIRE(rc::check("any lines", [] {
    std::string const text = *text_of({"\n", "\r\n", "\r", " ", "\t", "a", "0123456789", std::string(50, 'b'),
                                       ":", "\x01", "\x7F", "\xE4", "filter[0].order 1"}) +
                             std::string(room_behind_line, '#');
    for (std::uint32_t const begin : {0U, 3U}) RC_ASSERT(found_in(text, begin) == plainly_found(text, begin));
  }));
}

TEST_CASE("every byte is told apart at every place of a block") {
  for (int byte = 0; byte < 256; ++byte) {
    for (std::size_t place = 0; place < room_behind_line; ++place) {
      std::string text = std::string(room_behind_line, ',') + '\n' + std::string(2 * room_behind_line, ',');
      text[place] = static_cast<char>(byte);
      CAPTURE(byte, place);
      REQUIRE(found_in(text, 0) == plainly_found(text, 0));
      PlainLines lines;
      find_lines(text, 0, lines);
      bool const is_line_end = byte == '\n' || byte == '\r';
      bool const is_content = !is_line_end && !is(character::blank, text[place]);
      if (!is_unusual(text, place)) CHECK((lines.content[0] >> place & 1U) == (is_content ? 1U : 0U));
      if (is_line_end) continue;
      text[place == 0 ? 1 : 0] = '\n';
      text[room_behind_line] = '\r';
      text[room_behind_line + 1] = '\n';
      REQUIRE(found_in(text, 0) == plainly_found(text, 0));
    }
  }
}

TEST_CASE("wherever a number may be named it is seen") {
  constexpr std::uint32_t size = 4 * room_behind_line;
  auto const is_seen = [](std::string const& text, std::uint32_t begin) {
    PlainLines lines;
    find_lines(text, begin, lines);
    return lines.may_name_numbers;
  };
  for (std::uint32_t const begin : {0U, 5U}) {
    std::size_t const end = begin + (size - begin - 1) / room_behind_line * room_behind_line;
    for (std::size_t at = begin; at + 2 <= end; ++at) {
      std::string text(size, '-');
      text[at] = 'P';
      CAPTURE(begin, at);
      CHECK(is_seen(text, begin));
      text[at + 1] = 'P';
      text[at + 2 == size ? at : at + 2] = 'x';
      CHECK_FALSE(is_seen(text, begin));
    }
  }
  CHECK_FALSE(is_seen(std::string(size, 'P'), 0));
  // What was seen before stays.
  PlainLines lines;
  lines.may_name_numbers = true;
  find_lines(std::string(size, 'x'), 0, lines);
  CHECK(lines.may_name_numbers);
}

TEST_CASE("as many lines are found as there is room for") {
  auto const found = found_in(std::string(1000, '\n'), 0);
  CHECK(found.size() == lines_at_once);
  CHECK(found.back().begin == lines_at_once - 1);
  CHECK(found_in("short\n", 0).empty());
  CHECK(found_in(std::string(500, 'a') + "\n", 0).empty());
}

TEST_CASE("lines are found among the bytes that are searched at once") {
  std::string const behind(2 * room_behind_line, 'b');
  CHECK(found_in(std::string(bytes_at_once - 1, 'a') + "\n" + behind, 0).size() == 1);
  CHECK(found_in(std::string(bytes_at_once, 'a') + "\n" + behind, 0).empty());
  CHECK(found_in("a\n" + std::string(bytes_at_once, 'a') + "\n" + behind, 0).size() == 1);
}

struct Cut {
  std::vector<std::string> parts;
  std::size_t lines = 0;
};

Cut cut(std::string const& text) {
  std::string const whole = text + std::string(2 * room_behind_line, '#');
  PlainLines lines;
  find_lines(whole, 0, lines);
  std::array<Assignment, 20> assignments;
  Cut result;
  std::size_t const count = split_lines(whole, lines, result.lines, assignments);
  for (std::size_t i = 0; i < count; ++i) {
    Assignment const& each = assignments[i];
    for (axisc::Span const span : {each.name, each.value, each.trailer}) {
      result.parts.push_back(whole.substr(span.begin, span.size()));
    }
    result.parts.push_back(std::to_string(each.line) + " " +
                           std::to_string(static_cast<int>(each.trailer_kind)));
  }
  return result;
}

TEST_CASE("lines are cut into name, value and trailer up to the first that is not plain") {
  std::string const plain = "\n  \n# Kommentar\na.b  -1.5\n\tc LOWPASS ( d e \r\n=f %1 /x\r\ng 1 /* h\n";
  std::vector<std::string> const parts = {"a.b", "-1.5", "",   "4 0", "c", "LOWPASS", "( d e", "5 1",
                                          "=f",  "%1",   "/x", "6 4", "g", "1",       "/* h",  "7 3"};
  CHECK(cut(plain).parts == parts);
  for (std::string const& other : {std::string("Ende"), std::string("eNDE 1"), std::string("a"),
                                   std::string("a 1 \x01"), std::string("# a: b"), std::string("\xE4 1"),
                                   "a " + std::string(70, '1'), std::string(70, ' ') + "a"}) {
    CAPTURE(other);
    Cut const some = cut(plain + other + "\nz 1\n");
    CHECK(some.parts == parts);
    CHECK(some.lines == 7);
  }
  CHECK(cut(std::string("a 1\n") + std::string(30, '\n')).lines == 31);
}

TEST_CASE("a line is cut alike wherever it begins") {
  // The first line's comment moves the second one through two blocks.
  for (std::size_t before = 1; before <= 2 * room_behind_line; ++before) {
    for (std::size_t gap : {std::size_t{1}, std::size_t{20}, room_behind_line}) {
      CAPTURE(before, gap);
      std::string const line = "\tab  12" + std::string(gap, ' ') + "(c d\t \r\n";
      CHECK(cut("#" + std::string(before - 1, 'x') + "\n" + line).parts ==
            std::vector<std::string>{"ab", "12", "(c d", "2 1"});
      CHECK(cut("#" + std::string(before - 1, 'x') + "\n ab 12" + std::string(gap, '\t') + "\n").parts ==
            std::vector<std::string>{"ab", "12", "", "2 0"});
    }
  }
}

TEST_CASE("not more lines are cut than there is room for") {
  std::string text;
  for (int i = 0; i < 25; ++i) text += "a 1\n";
  Cut const some = cut(text);
  CHECK(some.lines == 20);
  CHECK(some.parts.size() == 80);
}

}  // namespace

}  // namespace plain_lines_test
