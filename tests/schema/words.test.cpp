#include "schema/words.hpp"

#include "diagnostics/ascii.hpp"
#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace axisc::schema;

TEST_CASE("words have their first byte lowest") {
  CHECK(word_at("\x01\x02\x03\x04\x05\x06\x07\xF8") == 0xF807060504030201U);
  CHECK(word_of("\x01\x02\xF3") == 0xF30201U);
  CHECK(word_of("") == 0);
  CHECK(word_of("abcdefgh") == word_at("abcdefgh"));
}

TEST_CASE("bytes are the same where each of them is") {
  for (std::size_t size = 0; size <= 70; ++size) {
    // Of exactly that size, so that a sanitizer sees every byte that is read besides.
    std::vector<char> const text(size, 'a');
    std::vector<char> other = text;
    REQUIRE(same_bytes(text.data(), other.data(), size));
    for (std::size_t at = 0; at < size; ++at) {
      other[at] = 'b';
      INFO(at << " of " << size);
      REQUIRE_FALSE(same_bytes(text.data(), other.data(), size));
      other[at] = 'a';
    }
  }
}

TEST_CASE("texts of different sizes are not the same") {
  CHECK(same_bytes("abc", "abc"));
  CHECK_FALSE(same_bytes("abc", "abcd"));
  CHECK_FALSE(same_bytes("", "a"));
}

TEST_CASE("every byte at every place of short texts is told to be a capital or not") {
  for (std::size_t size = 1; size <= 20; ++size) {
    for (std::size_t at = 0; at < size; ++at) {
      for (int byte = 0; byte < 256; ++byte) {
        std::string text(size, '_');
        text[at] = static_cast<char>(byte);
        if (at > 0) text[at - 1] = static_cast<char>(255 - byte);
        INFO(size << " " << at << " " << byte);
        REQUIRE(is_lower_case(text) == (axisc::ascii::lower_case(text) == text));
      }
    }
  }
  CHECK(is_lower_case(""));
}

}  // namespace
