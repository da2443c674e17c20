#include "validator/closest_word.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace axisc::validator {
namespace {

constexpr std::size_t longest_word = 64;

constexpr char fold(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Levenshtein distance, letter case aside.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::size_t const replaced = diagonal + (fold(a[i]) == fold(b[j]) ? 0U : 1U);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return fold(x) == fold(y); });
}

std::string_view closest_word(std::string_view written, std::vector<std::string_view> const& words) {
  if (written.size() > longest_word) return {};
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(written.size() / 3, 1) + 1;
  for (std::string_view const word : words) {
    std::size_t const edits = distance(written, word);
    if (edits >= best_distance || edits >= word.size()) continue;
    best = word;
    best_distance = edits;
  }
  return best;
}

}  // namespace axisc::validator
