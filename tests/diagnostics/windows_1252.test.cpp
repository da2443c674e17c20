#include "diagnostics/windows_1252.hpp"

#include "diagnostics/utf8.hpp"
#include "support/catch.hpp"

#include <string>

using namespace axisc;

TEST_CASE("the windows-1252 characters between 0x80 and 0x9F") {
  std::string text;
  for (int byte = 0x80; byte <= 0x9F; ++byte) append_utf8(text, decode_windows_1252(static_cast<char>(byte)));
  CHECK(text ==
        "€\xEF\xBF\xBD‚ƒ„…†‡ˆ‰Š‹Œ\xEF\xBF\xBDŽ\xEF\xBF\xBD"
        "\xEF\xBF\xBD‘’“”•–—˜™š›œ\xEF\xBF\xBDžŸ");
}

TEST_CASE("every byte that has a character comes back from it") {
  int without_character = 0;
  for (int number = 0; number < 256; ++number) {
    auto const byte = static_cast<char>(number);
    char32_t const character = decode_windows_1252(byte);
    if (character == replacement_character) {
      ++without_character;
    } else {
      CHECK(encode_windows_1252(character) == byte);
    }
  }
  CHECK(without_character == 5);
}

TEST_CASE("bytes outside 0x80 to 0x9F are their own number") {
  CHECK(decode_windows_1252('A') == U'A');
  CHECK(decode_windows_1252('\xFC') == U'ü');
  CHECK(decode_windows_1252('\xB5') == U'µ');
}

TEST_CASE("characters that windows-1252 lacks have no byte") {
  CHECK_FALSE(encode_windows_1252(0x80));
  CHECK_FALSE(encode_windows_1252(0x9D));
  CHECK_FALSE(encode_windows_1252(U'≤'));
  CHECK_FALSE(encode_windows_1252(replacement_character));
  CHECK_FALSE(encode_windows_1252(0x1F600));
}
