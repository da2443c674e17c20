#include "schema/closest_word.hpp"

#include "support/catch.hpp"

#include <array>
#include <string>
#include <string_view>

namespace closest_word_test {

namespace {

using axisc::schema::closest_word;

constexpr std::array<std::string_view, 4> known{"lint", "compile", "inspect", "ON"};

TEST_CASE("the closest word is suggested, letter case aside") {
  CHECK(closest_word("lnit", known) == "lint");
  CHECK(closest_word("Compil", known) == "compile");
  CHECK(closest_word("INSPECT", known) == "inspect");
}

TEST_CASE("words that are too different are not suggested") {
  CHECK(closest_word("run", known).empty());
  CHECK(closest_word("", known).empty());
  CHECK(closest_word(std::string(1000, 'l'), known).empty());
  // Of a single letter nothing would be left.
  CHECK(closest_word("x", std::array<std::string_view, 1>{"y"}).empty());
}

TEST_CASE("the first of equally near words wins") {
  CHECK(closest_word("axes", std::array<std::string_view, 2>{"axis", "axle"}) == "axis");
  CHECK(closest_word("lins", std::array<std::string_view, 2>{"link", "lint"}) == "link");
}

}  // namespace

}  // namespace closest_word_test
