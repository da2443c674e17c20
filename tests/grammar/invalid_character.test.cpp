#include "grammar/invalid_character.hpp"

#include "support/catch.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace invalid_character_test {

namespace {

using axisc::Span;
using axisc::grammar::find_invalid_character;

TEST_CASE("control characters are found wherever they stand") {
  for (std::size_t size = 1; size < 40; ++size) {
    for (std::size_t position = 0; position < size; ++position) {
      for (char const bad : {'\0', '\x01', '\x1F', '\x7F', '\r', '\v'}) {
        std::string line(size, 'x');
        line[position] = bad;
        for (bool const windows_1252 : {false, true}) {
          auto const found = find_invalid_character(line, windows_1252);
          REQUIRE(found);
          REQUIRE(found->begin == position);
          REQUIRE(found->size() == 1);
        }
      }
    }
  }
}

TEST_CASE("the first one counts") {
  CHECK(find_invalid_character(std::string_view("abc\x01\x02", 5), false) == Span{3, 4});
}

TEST_CASE("every other byte below 0x80 is a character") {
  for (int byte = 0; byte < 0x80; ++byte) {
    std::string const line(9, static_cast<char>(byte));
    bool const allowed = byte == '\t' || (byte >= 0x20 && byte != 0x7F);
    CHECK(find_invalid_character(line, false).has_value() != allowed);
  }
}

TEST_CASE("above 0x7F the encoding decides") {
  for (int byte = 0x80; byte < 0x100; ++byte) {
    std::string const line(9, static_cast<char>(byte));
    bool const undefined = byte == 0x81 || byte == 0x8D || byte == 0x8F || byte == 0x90 || byte == 0x9D;
    CHECK(find_invalid_character(line, true).has_value() == undefined);
    CHECK_FALSE(find_invalid_character(line, false).has_value());
  }
  CHECK(find_invalid_character("Gr\xC3\xB6\xC3\x9F"
                               "e",
                               false) == std::nullopt);
  CHECK(find_invalid_character("\xE2\x82\xAC 5", false) == std::nullopt);
}

TEST_CASE("the second set of control characters counts in UTF-8") {
  CHECK(find_invalid_character("abcdefg\xC2\x80", false) == Span{7, 9});
  CHECK(find_invalid_character("ab\xC2\x9F", false) == Span{2, 4});
  CHECK(find_invalid_character("ab\xC2\xA0", false) == std::nullopt);
  CHECK(find_invalid_character("ab\xC2", false) == std::nullopt);
  CHECK(find_invalid_character("ab\xC3\x9F", false) == std::nullopt);
}

}  // namespace

}  // namespace invalid_character_test
