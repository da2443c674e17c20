#include "schema/letters.hpp"

#include "schema/edit_distance.hpp"
#include "support/catch.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

namespace letters_test {

namespace {

using namespace axisc::schema;

TEST_CASE("letters say what is there, what is there twice and what is there an odd number of times") {
  CHECK(letter_sets_of("").letters == 0);
  CHECK(letter_sets_of("ab").letters == letter_sets_of("ba").letters);
  CHECK(letter_sets_of("ab").letters != letter_sets_of("aab").letters);
  CHECK(letter_sets_of("aab").letters == letter_sets_of("baaa").letters);
  CHECK(letter_sets_of("").odd == 0);
  CHECK(letter_sets_of("ab").odd == letter_sets_of("bccaaa").odd);
  CHECK(letter_sets_of("ab").odd != letter_sets_of("abb").odd);
}

TEST_CASE("sets of odd letters are told apart by how many letters differ") {
  std::array<OddLetters, letters_at_once> known{};
  for (std::size_t i = 0; i < known.size(); ++i) known[i] = static_cast<OddLetters>((1U << i) - 1U);
  for (std::size_t limit = 0; limit <= 8; ++limit) {
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < known.size(); ++i) expected |= i <= 2 * limit ? 1U << i : 0U;
    CHECK(may_be_within(limit, 0, known) == expected);
  }
}

TEST_CASE("every set of odd letters has its own bit") {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::array<OddLetters, letters_at_once> known{};
    auto const given = static_cast<OddLetters>(random());
    std::size_t const limit = random() % 9;
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
      known[i] = static_cast<OddLetters>(random() % 8 == 0 ? ~given : random());
      auto const differences =
          static_cast<std::size_t>(std::popcount(static_cast<unsigned>(given ^ known[i])));
      if (differences <= 2 * limit) expected |= 1U << i;
    }
    CHECK(may_be_within(limit, given, known) == expected);
  }
}

TEST_CASE("letters rule out nothing that is a few slips away") {
  std::mt19937 random(7);
  auto const byte = [&random] {
    return static_cast<char>("abcdefghijklmnopqrstuvwxyz_.0189"[random() % 32]);
  };
  for (int round = 0; round < 20000; ++round) {
    std::string known(1 + random() % 30, ' ');
    for (char& each : known) each = byte();
    std::string given = known;
    for (std::size_t slips = random() % 5; slips > 0; --slips) {
      std::size_t const at = random() % given.size();
      switch (random() % 4) {
        case 0: given.insert(at, 1, byte()); break;
        case 1:
          if (given.size() > 1) given.erase(at, 1);
          break;
        case 2: given[at] = byte(); break;
        default:
          if (at > 0) std::swap(given[at - 1], given[at]);
      }
    }
    constexpr std::size_t most = 6;
    std::size_t const distance = edit_distance(given, known, most);
    std::array<OddLetters, letters_at_once> all{};
    std::size_t const place = random() % all.size();
    all[place] = letter_sets_of(known).odd;
    for (std::size_t limit = distance; limit <= most; ++limit) {
      INFO(given << " " << known << " " << limit);
      REQUIRE_FALSE(certainly_beyond(letter_sets_of(given).letters, letter_sets_of(known).letters, limit));
      REQUIRE((may_be_within(limit, letter_sets_of(given).odd, all) & (1U << place)) != 0);
    }
  }
}

}  // namespace

}  // namespace letters_test
