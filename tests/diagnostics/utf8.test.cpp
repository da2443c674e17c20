#include "diagnostics/utf8.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string>

using namespace axisc;

namespace {

// The definition, spelled out: a sequence is well-formed when it is what encoding its own number gives.
std::string encode_by_definition(char32_t value) {
  auto const byte = [](char32_t number) { return static_cast<char>(static_cast<unsigned char>(number)); };
  if (value < 0x80) return {byte(value)};
  if (value < 0x800) return {byte(0xC0 + value / 64), byte(0x80 + value % 64)};
  if (value < 0x10000)
    return {byte(0xE0 + value / 4096), byte(0x80 + value / 64 % 64), byte(0x80 + value % 64)};
  return {byte(0xF0 + value / 262144), byte(0x80 + value / 4096 % 64), byte(0x80 + value / 64 % 64),
          byte(0x80 + value % 64)};
}

bool is_scalar(char32_t value) {
  return value < 0xD800 || (value > 0xDFFF && value <= 0x10FFFF);
}

}  // namespace

TEST_CASE("every code point survives encoding and decoding") {
  for (char32_t value = 0; value <= 0x10FFFF; ++value) {
    std::string encoded;
    append_utf8(encoded, value);
    char32_t const expected = is_scalar(value) ? value : replacement_character;
    DecodedCharacter const decoded = decode_utf8(encoded);
    if (encoded != encode_by_definition(expected) || decoded.value != expected ||
        decoded.size != encoded.size()) {
      FAIL("code point " << static_cast<unsigned>(value));
    }
  }
}

TEST_CASE("a code point above U+10FFFF becomes the replacement character") {
  std::string text;
  append_utf8(text, 0x110000);
  CHECK(text == "\xEF\xBF\xBD");
}

TEST_CASE("ill-formed sequences are refused at their first byte") {
  auto const* const text =
      GENERATE("\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x80\x80", "\xE0\x9F\xBF",
               "\xED\xA0\x80", "\xED\xBF\xBF", "\xE2\x82", "\xF0\x80\x80\x80", "\xF0\x8F\xBF\xBF",
               "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE", "\xFF", "\xF0\x9F\x98", "\xE2\x82\x41");
  CHECK(valid_utf8_prefix(text) == 0);
  DecodedCharacter const decoded = decode_utf8(text);
  CHECK(decoded.value == replacement_character);
  CHECK(decoded.size == 1);
}

TEST_CASE("all combinations of boundary bytes are judged as the definition does") {
  constexpr std::array<unsigned char, 25> bytes{0x00, 0x41, 0x7F, 0x80, 0x8F, 0x90, 0x9F, 0xA0, 0xBF,
                                                0xC0, 0xC1, 0xC2, 0xDF, 0xE0, 0xE1, 0xEC, 0xED, 0xEE,
                                                0xEF, 0xF0, 0xF1, 0xF3, 0xF4, 0xF5, 0xFF};
  constexpr std::size_t combinations = bytes.size() * bytes.size() * bytes.size() * bytes.size();
  std::size_t differences = 0;
  for (std::size_t number = 0; number < combinations; ++number) {
    std::string text;
    for (std::size_t rest = number, i = 0; i < 4; ++i, rest /= bytes.size()) {
      text += static_cast<char>(bytes.at(rest % bytes.size()));
    }
    // Payload bits of a sequence of `size` bytes, whatever they are; encoding them must give the same bytes.
    std::size_t expected = 0;
    for (std::size_t size = 1; size <= 4; ++size) {
      constexpr std::array<unsigned, 5> mask{0, 0x7F, 0x1F, 0x0F, 0x07};
      char32_t value = static_cast<unsigned char>(text[0]) & mask.at(size);
      for (std::size_t i = 1; i < size; ++i)
        value = value * 64 + (static_cast<unsigned char>(text[i]) & 0x3FU);
      if (is_scalar(value) && encode_by_definition(value) == text.substr(0, size)) expected = size;
    }
    DecodedCharacter const decoded = decode_utf8(text);
    bool const agrees = expected == 0 ? decoded.size == 1 && decoded.value == replacement_character
                                      : decoded.size == expected;
    if (!agrees) ++differences;
  }
  CHECK(differences == 0);
}

TEST_CASE("the valid prefix ends where the first ill-formed byte stands, wherever that is") {
  for (std::size_t before = 0; before < 40; ++before) {
    std::string const text = std::string(before, 'a') + "\xFF" + std::string(10, 'b');
    CHECK(valid_utf8_prefix(text) == before);
    CHECK(valid_utf8_prefix(std::string(before, 'a')) == before);
    CHECK(valid_utf8_prefix(std::string(before, 'a') + "µ") == before + 2);
    CHECK(valid_utf8_prefix(std::string(before, 'a') + "\xC2") == before);
  }
  CHECK(valid_utf8_prefix("") == 0);
}

TEST_CASE("repairing replaces bytes and nothing else") {
  CHECK(repair_utf8("") == "");
  CHECK(repair_utf8("Güte 12 µs €😀") == "Güte 12 µs €😀");
  CHECK(repair_utf8("G\xFCte") == "G\xEF\xBF\xBDte");
  CHECK(repair_utf8("\xE2\x82") == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(repair_utf8("a\xFF") == "a\xEF\xBF\xBD");
}

TEST_CASE("continuation bytes are counted wherever they stand") {
  std::string const characters = "aµ€😀\x7F\xC0\xBF\x80";
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (std::size_t size = random() % 40; size > 0; --size) text += characters[random() % characters.size()];
    CHECK(count_continuation_bytes(text) ==
          static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_continuation_byte)));
  }
}

TEST_CASE("long texts are searched piece by piece, to every byte") {
  for (std::size_t const before : {0U, 1U, 255U, 256U, 257U, 511U, 512U, 513U, 1000U}) {
    for (std::size_t const behind : {0U, 1U, 7U, 255U, 256U, 300U}) {
      std::string const head(before, 'a');
      std::string const tail(behind, 'b');
      CHECK(valid_utf8_prefix(head + "\xFF" + tail) == before);
      CHECK(valid_utf8_prefix(head + "µ" + tail) == before + 2 + behind);
      CHECK(valid_utf8_prefix(head + "\xC2" + tail) == before);
    }
  }
}

TEST_CASE("a text is ASCII where each of its bytes is") {
  for (std::size_t size = 0; size <= 600; size += size < 70 ? 1 : 53) {
    std::string text(size, 'a');
    REQUIRE(ascii_prefix(text) == size);
    for (std::size_t at = 0; at < size; ++at) {
      text[at] = '\xC3';
      std::size_t const prefix = ascii_prefix(text);
      INFO(at << " of " << size);
      REQUIRE(prefix <= at);
      REQUIRE(at - prefix < 8);
      text[at] = 'a';
    }
  }
}
