#include "schema/vocabulary.hpp"

#include "schema/indexed_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace axisc::schema {
namespace {

std::vector<std::string_view> split(std::string_view name) {
  std::vector<std::string_view> parts;
  while (!name.empty()) parts.push_back(take_part(name));
  return parts;
}

/// `keys[i]` says to which of `count` groups number i belongs.
VocabularyTables::OwnGroups group_by(std::vector<std::uint32_t> const& keys, std::size_t count) {
  VocabularyTables::OwnGroups groups;
  groups.starts.resize(count + 1);
  for (std::uint32_t const key : keys) ++groups.starts[key + 1];
  std::partial_sum(groups.starts.begin(), groups.starts.end(), groups.starts.begin());
  std::vector<std::uint32_t> next = groups.starts;
  groups.numbers.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    groups.numbers[next[keys[i]]++] = static_cast<std::uint32_t>(i);
  }
  return groups;
}

}  // namespace

Letters letters_of(std::string_view text) {
  constexpr unsigned letters = 32;
  Letters once = 0;
  Letters twice = 0;
  for (char const byte : text) {
    Letters const letter = Letters{1} << (static_cast<unsigned char>(byte) % letters);
    twice |= once & letter;
    once |= letter;
  }
  return once | twice << letters;
}

VocabularyTables::VocabularyTables(std::vector<std::string> const& patterns) {
  names.reserve(patterns.size());
  for (std::string const& pattern : patterns) names.push_back(without_brackets(pattern));
  name_views.assign(names.begin(), names.end());
  alphabetic.resize(names.size());
  std::iota(alphabetic.begin(), alphabetic.end(), std::uint32_t{0});
  std::stable_sort(alphabetic.begin(), alphabetic.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return names[a] < names[b]; });

  std::vector<std::uint32_t> sizes;
  for (std::string const& name : names) sizes.push_back(static_cast<std::uint32_t>(name.size()));
  std::size_t const longest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  names_of_size = group_by(sizes, longest + 1);
  for (std::uint32_t const name : names_of_size.numbers) letters_by_size.push_back(letters_of(names[name]));

  for (std::string const& name : names) {
    for (std::string_view const part : split(name)) parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  for (std::string_view const part : parts) letters_of_parts.push_back(letters_of(part));

  std::vector<std::uint32_t> endings;
  parts_of.starts.push_back(0);
  for (std::string const& name : names) {
    for (std::string_view const part : split(name)) {
      auto const place = std::lower_bound(parts.begin(), parts.end(), part);
      parts_of.numbers.push_back(static_cast<std::uint32_t>(place - parts.begin()));
    }
    parts_of.starts.push_back(static_cast<std::uint32_t>(parts_of.numbers.size()));
    endings.push_back(parts_of.numbers.back());
  }
  names_ending_in = group_by(endings, parts.size());
}

Vocabulary VocabularyTables::view(std::span<Parameter const> rows) const {
  return {.rows = rows,
          .names = name_views,
          .alphabetic = alphabetic,
          .names_of_size = names_of_size.view(),
          .letters_by_size = letters_by_size,
          .parts = parts,
          .letters_of_parts = letters_of_parts,
          .parts_of = parts_of.view(),
          .names_ending_in = names_ending_in.view()};
}

}  // namespace axisc::schema
