#include "presentation/quantity.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <limits>

using namespace axisc;
using namespace axisc::presentation;

TEST_CASE("a quantity has the reader's decimal sign, and its unit after a blank") {
  Quantity const delay{.value = 13.7812, .unit = Unit::millisecond, .digits = Digits::significant(3)};
  CHECK(quantity_text(delay, Language::english) == "13.8 ms");
  CHECK(quantity_text(delay, Language::german) == "13,8 ms");
  CHECK(quantity_text({.value = 90, .unit = Unit::degree}, Language::german) == "90°");
  CHECK(quantity_text({.value = 0.5, .unit = Unit::percent}, Language::german) == "0,5 %");
  CHECK(quantity_text({.value = 3, .unit = Unit::cycle}, Language::german) == "3 Zyklen");
}

TEST_CASE("decimals are kept, and zero has no sign") {
  CHECK(number_text({.value = 2, .digits = Digits::decimals(3)}, Language::english) == "2.000");
  CHECK(number_text({.value = -0.0004, .digits = Digits::decimals(3)}, Language::english) == "0.000");
  CHECK(number_text({.value = 1e300, .digits = Digits::decimals(1)}, Language::english).size() == 303);
}

TEST_CASE("what is no finite number is shown, and null for programs") {
  auto const infinite = std::numeric_limits<double>::infinity();
  CHECK(quantity_text({.value = -infinite, .unit = Unit::decibel}, Language::english) == "-∞ dB");
  CHECK(quantity_text({.value = std::nan(""), .unit = Unit::decibel}, Language::english) == "-");
  CHECK(json_number(infinite) == "null");
  CHECK(json_number(0.1) == "0.1");
}

TEST_CASE("every unit has a symbol") {
  for (auto unit = static_cast<unsigned>(Unit::cycle); unit <= static_cast<unsigned>(Unit::byte); ++unit) {
    CHECK_FALSE(symbol(static_cast<Unit>(unit), Language::english).empty());
  }
}
