#include "schema/letters.hpp"

#include "schema/words.hpp"

#include <array>

namespace axisc::schema {
namespace {

/// By additions alone, which compilers do for many numbers at once.
constexpr std::uint16_t count_bits(std::uint16_t bits) {
  unsigned const pairs = (bits & 0x5555U) + ((bits >> 1U) & 0x5555U);
  unsigned const nibbles = (pairs & 0x3333U) + ((pairs >> 2U) & 0x3333U);
  unsigned const bytes = (nibbles & 0x0F0FU) + ((nibbles >> 4U) & 0x0F0FU);
  return static_cast<std::uint16_t>((bytes & 0x00FFU) + (bytes >> 8U));
}

/// Eight bytes that are 0 or 1 as one bit each, the first one lowest.
std::uint32_t gather(char const* bytes) {
  constexpr std::uint64_t gathering = 0x0102040810204080;  // byte i to bit 56 + i
  return static_cast<std::uint32_t>((word_at(bytes) * gathering) >> 56U);
}

}  // namespace

LetterSets letter_sets_of(std::string_view text) {
  constexpr unsigned letters = 32;
  std::uint32_t once = 0;
  std::uint32_t twice = 0;
  std::uint32_t odd = 0;
  for (char const byte : text) {
    std::uint32_t const letter = std::uint32_t{1} << (static_cast<unsigned char>(byte) % letters);
    twice |= once & letter;
    once |= letter;
    odd ^= letter;
  }
  return {.letters = once | Letters{twice} << letters,
          .odd = static_cast<OddLetters>(odd ^ odd >> letters / 2)};
}

std::uint32_t may_be_within(std::size_t limit, OddLetters given,
                            std::span<OddLetters const, letters_at_once> known) {
  auto const most = static_cast<std::uint16_t>(2 * limit);
  std::array<char, letters_at_once> possible;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (std::size_t i = 0; i < letters_at_once; ++i) {
    possible[i] = count_bits(given ^ known[i]) <= most ? 1 : 0;
  }
  return gather(possible.data()) | gather(possible.data() + 8) << 8U;
}

}  // namespace axisc::schema
