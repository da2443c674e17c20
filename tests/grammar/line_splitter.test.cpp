#include "grammar/line_splitter.hpp"

#include "grammar/axis_list.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace line_splitter_test {

namespace {

using Lines = std::vector<std::string>;

Lines split(std::string_view text) {
  Lines lines;
  axisc::grammar::LineSplitter splitter(text);
  for (std::string_view line; splitter.next(line);) {
    lines.emplace_back(line);
    CHECK(splitter.number() == lines.size());
  }
  return lines;
}

TEST_CASE("lines end with LF, CR LF or the text") {
  CHECK(split("").empty());
  CHECK(split("a") == Lines{"a"});
  CHECK(split("a\n") == Lines{"a"});
  CHECK(split("a\r\n") == Lines{"a"});
  CHECK(split("a\r") == Lines{"a"});
  CHECK(split("\n") == Lines{""});
  CHECK(split("\r\n\n\r\n") == Lines{"", "", ""});
  CHECK(split("a\nb\r\n\nc") == Lines{"a", "b", "", "c"});
}

TEST_CASE("any other CR is part of its line") {
  CHECK(split("a\rb\n") == Lines{"a\rb"});
  CHECK(split("a\r\r\n") == Lines{"a\r"});
}

TEST_CASE("the longest line counts bytes without its line end") {
  CHECK(axisc::grammar::longest_line_in("") == 0);
  CHECK(axisc::grammar::longest_line_in("ab\r\nabcd\r\nabc") == 4);
  CHECK(axisc::grammar::longest_line_in(std::string(5000, 'x')) == 5000);
}

}  // namespace

}  // namespace line_splitter_test
