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

void sort_and_drop_repetitions(std::vector<std::string_view>& texts) {
  std::sort(texts.begin(), texts.end());
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
}

std::string_view family_of(std::string_view name) {
  return name.substr(0, name.rfind('.') + 1);
}

/// `keys[i]` is the group, out of `count`, of number i.
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

VocabularyTables::VocabularyTables(std::vector<std::string> const& patterns) {
  names.reserve(patterns.size());
  for (std::string const& pattern : patterns) names.push_back(without_brackets(pattern));
  name_views.assign(names.begin(), names.end());

  std::vector<std::uint32_t> sizes;
  for (std::string const& name : names) sizes.push_back(static_cast<std::uint32_t>(name.size()));
  std::size_t const longest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  names_of_size = group_by(sizes, longest + 1);
  for (std::uint32_t const name : names_of_size.numbers) {
    LetterSets const sets = letter_sets_of(names[name]);
    letters_by_size.push_back(sets.letters);
    odd_letters_by_size.push_back(sets.odd);
  }
  odd_letters_by_size.resize(names.size() + letters_at_once - 1);

  for (std::string const& name : names) {
    for (std::string_view const part : split(name)) parts.push_back(part);
  }
  sort_and_drop_repetitions(parts);
  places_of_parts = make_text_places(parts);
  auto const place_of_part = [this](std::string_view part) {
    return static_cast<std::uint32_t>(find_text(part, parts, places_of_parts).value());
  };

  std::vector<std::uint32_t> endings;
  parts_of.starts.push_back(0);
  for (std::string const& name : names) {
    for (std::string_view const part : split(name)) {
      parts_of.numbers.push_back(place_of_part(part));
    }
    parts_of.starts.push_back(static_cast<std::uint32_t>(parts_of.numbers.size()));
    endings.push_back(parts_of.numbers.back());
  }
  names_ending_in = group_by(endings, parts.size());

  for (std::string const& name : names) families.push_back(family_of(name));
  sort_and_drop_repetitions(families);
  places_of_families = make_text_places(families);
  std::vector<std::uint32_t> own_families;
  for (std::string const& name : names) {
    auto const place = find_text(family_of(name), families, places_of_families).value();
    own_families.push_back(static_cast<std::uint32_t>(place));
  }
  names_of_family = group_by(own_families, families.size());
  for (std::uint32_t const name : names_of_family.numbers) {
    letters_by_family.push_back(letter_sets_of(parts[endings[name]]).letters);
  }
}

Vocabulary VocabularyTables::view(std::span<Parameter const> rows) const {
  return {.rows = rows,
          .names = name_views,
          .names_of_size = names_of_size.view(),
          .letters_by_size = letters_by_size,
          .odd_letters_by_size = odd_letters_by_size,
          .parts = parts,
          .places_of_parts = places_of_parts,
          .parts_of = parts_of.view(),
          .names_ending_in = names_ending_in.view(),
          .families = families,
          .places_of_families = places_of_families,
          .names_of_family = names_of_family.view(),
          .letters_by_family = letters_by_family};
}

}  // namespace axisc::schema
