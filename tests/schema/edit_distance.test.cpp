#include "schema/edit_distance.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace edit_distance_test {

namespace {

using axisc::schema::edit_distance;
using axisc::schema::tolerable_distance;

TEST_CASE("one slip is a distance of one") {
  CHECK(edit_distance("order", "order", 3) == 0);
  CHECK(edit_distance("oder", "order", 3) == 1);
  CHECK(edit_distance("orrder", "order", 3) == 1);
  CHECK(edit_distance("otder", "order", 3) == 1);
  CHECK(edit_distance("oredr", "order", 3) == 1);
}

TEST_CASE("slips add up, and a swapped pair is not edited again") {
  CHECK(edit_distance("", "abc", 5) == 3);
  CHECK(edit_distance("kitten", "sitting", 5) == 3);
  CHECK(edit_distance("ca", "abc", 5) == 3);
}

TEST_CASE("distances beyond the limit are not told apart") {
  CHECK(edit_distance("kitten", "sitting", 2) == 3);
  CHECK(edit_distance("abc", "xyz", 0) == 1);
  CHECK(edit_distance("a", std::string(1000, 'a'), 4) == 5);
}

/// The textbook's table, whole.
std::size_t plain_distance(std::string const& a, std::string const& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

TEST_CASE("the band gives what the whole table gives") {
  std::mt19937 random(1);
  auto const word = [&random] {
    std::string text(random() % 9, ' ');
    for (char& byte : text) byte = static_cast<char>('a' + random() % 3);
    return text;
  };
  for (int round = 0; round < 20000; ++round) {
    std::string const a = word();
    std::string const b = word();
    std::size_t const expected = plain_distance(a, b);
    for (std::size_t const limit : {0U, 1U, 2U, 4U, 20U}) {
      INFO(a << " " << b << " " << limit);
      REQUIRE(edit_distance(a, b, limit) == std::min(expected, limit + 1));
    }
  }
}

TEST_CASE("what two words have in common at their ends does not count") {
  std::mt19937 random(3);
  auto const word = [&random](std::size_t longest) {
    std::string text(random() % (longest + 1), ' ');
    for (char& byte : text) byte = static_cast<char>(random() % 2 == 0 ? 'a' : 0xE4);
    return text;
  };
  for (int round = 0; round < 20000; ++round) {
    std::string const beginning = word(20);
    std::string const end = word(20);
    std::string const a = beginning + word(3) + end;
    std::string const b = beginning + word(3) + end;
    INFO(a << " " << b);
    REQUIRE(edit_distance(a, b, 9) == plain_distance(a, b));
  }
}

TEST_CASE("longer words tolerate more slips") {
  CHECK(tolerable_distance(0) == 1);
  CHECK(tolerable_distance(5) == 1);
  CHECK(tolerable_distance(6) == 2);
  CHECK(tolerable_distance(100) == 4);
}

TEST_CASE("long words are compared like short ones") {
  std::mt19937 random(2);
  auto const word = [&random](std::size_t size) {
    std::string text(size, ' ');
    for (char& byte : text) byte = static_cast<char>('a' + random() % 4);
    return text;
  };
  for (int round = 0; round < 400; ++round) {
    // On both sides of what fits one word of the processor, ends that differ so that nothing is cut off.
    std::string const a = 'x' + word(random() % 90) + 'x';
    std::string b = 'y' + word(random() % 90) + 'y';
    if (round % 2 == 0) {
      b = 'y' + a.substr(1, a.size() - 2) + 'y';
      for (std::size_t slips = random() % 6; slips > 0; --slips) {
        std::size_t const at = random() % (b.size() - 1);
        std::swap(b[at], b[at + 1]);
        b.insert(random() % b.size(), 1, 'c');
      }
    }
    std::size_t const distance = plain_distance(a, b);
    for (std::size_t const limit :
         {std::size_t{0}, std::size_t{2}, std::size_t{4}, distance, a.size() + b.size()}) {
      INFO(a << ' ' << b << ' ' << limit);
      REQUIRE(edit_distance(a, b, limit) == std::min(distance, limit + 1));
    }
  }
}

}  // namespace

}  // namespace edit_distance_test
