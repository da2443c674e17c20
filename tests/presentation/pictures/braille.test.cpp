#include "presentation/pictures/braille.hpp"

#include "support/catch.hpp"

#include <sstream>

namespace braille_test {

using namespace axisc;
using namespace axisc::pictures;
using Catch::Matchers::Contains;

namespace {

/// The dots of a letter from U+2800 on, in UTF-8.
unsigned dots(std::string const& letter) {
  return ((static_cast<unsigned char>(letter[1]) & 0x03U) << 6U) |
         (static_cast<unsigned char>(letter[2]) & 0x3FU);
}

bool lowest_left(std::string const& letter) {
  return (dots(letter) & 0x40U) != 0;
}

bool uppermost_right(std::string const& letter) {
  return (dots(letter) & 0x08U) != 0;
}

}  // namespace

TEST_CASE("a rising line goes from the lower left to the upper right letter") {
  Figure figure{.title = "line", .x = {.quantity = "time", .unit = "s", .low = 0, .high = 1}};
  figure.panels.push_back({.y = {.quantity = "way", .unit = "m", .low = 0, .high = 2},
                           .curves = {{.name = "a", .points = {{.x = 0, .y = 0}, {.x = 1, .y = 2}}}}});
  std::istringstream lines(braille(figure, 50, Language::english));
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  CHECK(all.front() == "line");
  CHECK_THAT(all[1], Contains("way [m]"));
  // The first letter has the lowest dot of its left column, the last one the uppermost of its right column.
  CHECK(lowest_left(all[all.size() - 2].substr(10, 3)));
  CHECK(uppermost_right(all[2].substr(all[2].size() - 3)));
  CHECK_THAT(all[2].substr(0, 10), Contains("2"));
  CHECK_THAT(all.back(), Contains("0  time") && Catch::Matchers::EndsWith("1 s"));
}

TEST_CASE("the terminal says that there is nothing to draw") {
  Figure const figure{.title = "none", .nothing = "no filter"};
  CHECK(braille(figure, 80, Language::english) == "none\nno filter\n");
}

}  // namespace braille_test
