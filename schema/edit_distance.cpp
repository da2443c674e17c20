#include "schema/edit_distance.hpp"

#include "schema/words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace axisc::schema {
namespace {

constexpr std::size_t word_size = 8;

std::size_t common_prefix(std::string_view a, std::string_view b) {
  std::size_t const most = std::min(a.size(), b.size());
  std::size_t same = 0;
  for (; same + word_size <= most; same += word_size) {
    std::uint64_t const difference = word_at(a.data() + same) ^ word_at(b.data() + same);
    if (difference != 0) return same + static_cast<std::size_t>(std::countr_zero(difference)) / 8;
  }
  while (same < most && a[same] == b[same]) ++same;
  return same;
}

std::size_t common_suffix(std::string_view a, std::string_view b) {
  std::size_t const most = std::min(a.size(), b.size());
  std::size_t same = 0;
  for (; same + word_size <= most; same += word_size) {
    std::uint64_t const difference =
        word_at(a.data() + a.size() - same - word_size) ^ word_at(b.data() + b.size() - same - word_size);
    if (difference != 0) return same + static_cast<std::size_t>(std::countl_zero(difference)) / 8;
  }
  while (same < most && a[a.size() - 1 - same] == b[b.size() - 1 - same]) ++same;
  return same;
}

void drop_common_ends(std::string_view& a, std::string_view& b) {
  std::size_t const prefix = common_prefix(a, b);
  a.remove_prefix(prefix);
  b.remove_prefix(prefix);
  std::size_t const suffix = common_suffix(a, b);
  a.remove_suffix(suffix);
  b.remove_suffix(suffix);
}

constexpr std::size_t word_bits = 64;

/// A column of the table as bits, one for each letter of `a`, which has at most 64: Myers' algorithm in the
/// form of Hyyrö (2003), which knows swaps. `rise` and `fall` mark where the column goes up and down by one,
/// `diagonal` where it repeats the value up and left of it.
std::size_t distance_in_words(std::string_view a, std::string_view b, std::size_t limit) {
  // Most words are short compared with the alphabet: only the letters that occur get a place.
  std::array<std::uint64_t, 256> places;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (char const byte : a) places[static_cast<unsigned char>(byte)] = 0;
  for (char const byte : b) places[static_cast<unsigned char>(byte)] = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    places[static_cast<unsigned char>(a[i])] |= std::uint64_t{1} << i;
  }
  std::uint64_t const last = std::uint64_t{1} << (a.size() - 1);
  std::uint64_t rise = ~std::uint64_t{0};
  std::uint64_t fall = 0;
  std::uint64_t diagonal = 0;
  std::uint64_t matches_before = 0;
  std::size_t distance = a.size();
  for (std::size_t j = 0; j < b.size(); ++j) {
    std::uint64_t const matches = places[static_cast<unsigned char>(b[j])];
    std::uint64_t const swaps = ((~diagonal & matches) << 1U) & matches_before;
    diagonal = (((matches & rise) + rise) ^ rise) | matches | fall | swaps;
    std::uint64_t right_up = fall | ~(diagonal | rise);
    std::uint64_t right_down = diagonal & rise;
    if ((right_up & last) != 0) ++distance;
    if ((right_down & last) != 0) --distance;
    // Every letter of `b` that is left takes away one at most.
    if (distance > limit + (b.size() - 1 - j)) return limit + 1;
    right_up = (right_up << 1U) | 1U;
    right_down <<= 1U;
    rise = right_down | ~(diagonal | right_up);
    fall = diagonal & right_up;
    matches_before = matches;
  }
  return distance;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  std::size_t const beyond = limit + 1;
  if (std::max(a.size(), b.size()) > longest_compared) return a == b ? 0 : beyond;
  drop_common_ends(a, b);
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > limit) return beyond;
  if (a.empty()) return b.size();
  if (a.size() <= word_bits) return std::min(distance_in_words(a, b, limit), beyond);

  // The usual table, of which three rows are kept. Only cells within `limit` of the diagonal can count; the
  // cells outside that band hold a value that is never the smallest.
  constexpr std::size_t infinite = 4 * longest_compared;
  std::array<std::array<std::size_t, longest_compared + 2>, 3>
      rows;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    auto const& last = rows[(i + 2) % 3];
    auto const& before_last = rows[(i + 1) % 3];
    std::size_t const first = i > limit ? i - limit : 1;
    std::size_t const end = std::min(b.size(), i + limit);
    row[first - 1] = i <= limit ? i : infinite;
    std::size_t smallest = row[first - 1];
    for (std::size_t j = first; j <= end; ++j) {
      std::size_t const replacement = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replacement, last[j] + 1, row[j - 1] + 1});
      bool const swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
      smallest = std::min(smallest, row[j]);
    }
    row[end + 1] = infinite;
    if (smallest > limit) return beyond;
  }
  return std::min(rows[a.size() % 3][b.size()], beyond);
}

}  // namespace axisc::schema
