#include "diagnostics/writers/shown_line.hpp"

#include "support/catch.hpp"

#include <string>
#include <string_view>

using namespace axisc;

namespace {

struct Shown {
  std::string text;
  std::string indent;
  std::size_t width;
};

Shown show_line(std::string_view line, MarkedPart marked, std::size_t room = 160) {
  ShownLine const shown(line, marked, room);
  Shown written{.text = {}, .indent = {}, .width = shown.width()};
  shown.append_text(written.text);
  shown.append_indent(written.indent);
  return written;
}

std::string repeated(std::string_view text, std::size_t times) {
  std::string result;
  for (; times > 0; --times) result += text;
  return result;
}

}  // namespace

TEST_CASE("a short line is shown whole") {
  Shown const shown = show_line("name  value", {.begin = 6, .end = 11});
  CHECK(shown.text == "name  value");
  CHECK(shown.indent == std::string(6, ' '));
  CHECK(shown.width == 5);
}

TEST_CASE("characters are counted, not bytes") {
  Shown const shown = show_line("Güte µ€😀 5", {.begin = 9, .end = 10});
  CHECK(shown.indent == std::string(9, ' '));
  CHECK(shown.width == 1);
}

TEST_CASE("tabs are repeated under the line") {
  Shown const shown = show_line("\tname\tvalue", {.begin = 6, .end = 11});
  CHECK(shown.text == "\tname\tvalue");
  CHECK(shown.indent == "\t    \t");
}

TEST_CASE("tabs are repeated under a line that is cut") {
  std::string const line = std::string(200, 'a') + "\tb\t" + "VALUE" + std::string(200, 'c');
  Shown const shown = show_line(line, {.begin = 203, .end = 208});
  CHECK(shown.text.starts_with("…" + std::string(49, 'a') + "\tb\tVALUE"));
  CHECK(shown.indent == std::string(50, ' ') + "\t \t");
}

TEST_CASE("control characters are shown as pictures of the same width") {
  Shown const shown = show_line("a\x01\x1b[31m value", {.begin = 8, .end = 13});
  CHECK(shown.text == "a␁␛[31m value");
  CHECK(shown.indent.size() == 8);
}

TEST_CASE("an empty part is one character wide") {
  CHECK(show_line("abc", {.begin = 1, .end = 1}).width == 1);
  CHECK(show_line("abc", {.begin = 3, .end = 3}).indent.size() == 3);
  CHECK(show_line("", {.begin = 0, .end = 0}).width == 1);
  CHECK(show_line("abc", {.begin = 99, .end = 120}).indent.size() == 3);
}

TEST_CASE("a part that goes on behind the line ends with it") {
  CHECK(show_line("abcdef", {.begin = 2, .end = std::string::npos}).width == 4);
}

TEST_CASE("long lines are cut around the marked part") {
  std::string const line = repeated("ü", 400) + "VALUE" + repeated("µ", 400);
  Shown const shown = show_line(line, {.begin = 400, .end = 405});
  CHECK(shown.text == "…" + repeated("ü", 52) + "VALUE" + repeated("µ", 101) + "…");
  CHECK(shown.indent.size() == 53);
  CHECK(shown.width == 5);
}

TEST_CASE("only the side that is too long is cut") {
  std::string const line(161, 'x');
  Shown const front = show_line(line, {.begin = 0, .end = 1});
  CHECK(front.text == std::string(159, 'x') + "…");
  CHECK(front.indent.empty());
  Shown const back = show_line(line, {.begin = 160, .end = 161});
  CHECK(back.text == "…" + std::string(159, 'x'));
  CHECK(back.indent.size() == 159);
  CHECK(show_line(std::string(160, 'x'), {.begin = 159, .end = 160}).text == std::string(160, 'x'));
}

TEST_CASE("a marked part longer than the shown line is cut with it") {
  Shown const shown = show_line(std::string(1000, 'x'), {.begin = 100, .end = 1000});
  CHECK(shown.indent.size() == 1);
  CHECK(shown.width == 158);
}

TEST_CASE("a comment far to the right is shown in a narrow terminal") {
  std::string const line =
      "getriebe[0].dynamik.vb_max   200000   ( P-AXIS-00213 : 200 mm/s, rapid traverse of the axis";
  Shown const shown = show_line(line, {.begin = 40, .end = 52}, 50);
  CHECK(shown.text.find("P-AXIS-00213") != std::string::npos);
  CHECK(shown.text.find("P-AXIS-00213") - std::string("…").size() + 1 == shown.indent.size());
  CHECK(shown.width == 12);
}
