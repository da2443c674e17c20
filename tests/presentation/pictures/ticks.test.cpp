#include "presentation/pictures/ticks.hpp"

#include "support/catch.hpp"

namespace ticks_test {

using namespace axisc;
using namespace axisc::pictures;

TEST_CASE("labels of a linear axis are multiples of 1, 2 or 5 times a power of ten") {
  CHECK(ticks_of({.low = 0, .high = 10}, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
  CHECK(ticks_of({.low = -0.3, .high = 0.7}, 5).size() == 5);
  CHECK(ticks_of({.low = -80, .high = 4}, 6) ==
        std::vector<double>{-80, -70, -60, -50, -40, -30, -20, -10, 0});
  CHECK(ticks_of({.low = 1e-9, .high = 3e-9}, 4).size() >= 4);
}

TEST_CASE("labels of a logarithmic axis are powers of ten, with 2 and 5 where there is room") {
  Axis const axis{.scale = Scale::logarithmic, .low = 0.05, .high = 500};
  CHECK(ticks_of(axis, 6) == std::vector<double>{0.1, 1, 10, 100});
  CHECK(ticks_of(axis, 12).size() == 13);
  CHECK(ticks_of({.ticks = {1, 3}}, 6) == std::vector<double>{1, 3});
}

TEST_CASE("numbers are written as the language does") {
  CHECK(number_text(-0.5, Language::english) == "-0.5");
  CHECK(number_text(-0.5, Language::german) == "-0,5");
  CHECK(number_text(1500, Language::english) == "1500");
  CHECK(number_text(20000, Language::english) == "20\u202F000");
  CHECK(number_text(-1234567, Language::german) == "-1\u202F234\u202F567");
  CHECK(number_text(1e-7, Language::german) == "1e-07");
}

}  // namespace ticks_test
