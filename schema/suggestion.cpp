#include "diagnostics/ascii.hpp"
#include "schema/catalogue.hpp"
#include "schema/edit_distance.hpp"
#include "schema/indexed_name.hpp"
#include "schema/name_candidates.hpp"
#include "schema/vocabulary.hpp"
#include "schema/words.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace axisc::schema {
namespace {

constexpr std::size_t most_suggestions = 3;
std::size_t index_count(IndexedName const& name) {
  auto const is_indexed = [](NamePart const& part) { return part.index.has_value(); };
  return static_cast<std::size_t>(std::count_if(name.parts.begin(), name.parts.end(), is_indexed));
}

/// The best first; of equal ones those with as many indices, then the rows in their order.
void put_in_order(std::vector<Candidate>& candidates, Vocabulary const& vocabulary, std::size_t indices) {
  auto const key = [&](Candidate const& candidate) {
    std::size_t const wanted = vocabulary.rows[candidate.name].index_count();
    std::size_t const difference = wanted > indices ? wanted - indices : indices - wanted;
    return std::tuple(candidate.slip, difference, candidate.text_distance, candidate.name);
  };
  std::sort(candidates.begin(), candidates.end(),
            [&key](Candidate const& a, Candidate const& b) { return key(a) < key(b); });
}

/// A quantity alone (`enable`) does not say which of many families was meant.
void drop_arbitrary(std::vector<Candidate>& candidates) {
  constexpr int most_families = 2;
  auto const is_alone = [](Candidate const& candidate) { return !candidate.begins_alike; };
  if (std::count_if(candidates.begin(), candidates.end(), is_alone) > most_families) {
    std::erase_if(candidates, is_alone);
  }
}

/// The best candidate can be meant alone: its name has as many indices and begins alike, and no other comes
/// near.
bool is_certain(std::vector<Candidate> const& candidates, Vocabulary const& vocabulary, std::size_t indices) {
  Candidate const& best = candidates.front();
  // Two names may differ in their indices alone.
  auto const rival = std::find_if(candidates.begin() + 1, candidates.end(), [&](Candidate const& other) {
    return vocabulary.names[other.name] != vocabulary.names[best.name];
  });
  bool const rivalled =
      rival != candidates.end() && static_cast<int>(rival->slip) < 2 * static_cast<int>(best.slip);
  return best.slip <= Slip::two_letters && best.begins_alike && !rivalled &&
         vocabulary.rows[best.name].index_count() == indices;
}

/// The known name with the indices of the given one; 0 where there are too few. None when one is out of range
/// there.
std::optional<std::string> with_indices(Parameter const& parameter, IndexedName const& given) {
  if (parameter.index_count() == 0) return std::string(parameter.name);
  constexpr std::size_t usual_digits = 4;
  std::string name;
  name.reserve(parameter.name.size() + usual_digits);
  std::size_t position = 0;
  auto part = given.parts.begin();
  for (std::string_view rest = parameter.name; !rest.empty();) {
    std::size_t const end = std::min(rest.find('['), rest.size() - 1) + 1;
    name += rest.substr(0, end);
    rest.remove_prefix(end);
    if (name.back() != '[') break;
    while (part != given.parts.end() && !part->index) ++part;
    std::uint32_t const index = part != given.parts.end() ? *part++->index : 0;
    if (index >= parameter.array.at(position)) return std::nullopt;
    name += std::to_string(index);
    ++position;
  }
  return name;
}

/// How far `word` is from a symbol; none when it is too far.
std::optional<std::size_t> symbol_distance(std::string_view word, std::string_view symbol) {
  std::size_t const limit = tolerable_distance(word.size());
  std::size_t const slips = edit_distance(word, symbol, limit);
  if (slips <= limit) return slips;
  constexpr std::size_t fewest_letters = 3;
  if (word.size() >= fewest_letters && (symbol.starts_with(word) || resembles(word, symbol))) {
    return limit + 1;
  }
  return std::nullopt;
}

}  // namespace

NameSuggestions suggest_names(Vocabulary const& vocabulary, std::string_view name) {
  NameSuggestions suggestions;
  if (name.size() > longest_compared) return suggestions;
  std::string folded;
  if (!is_lower_case(name)) {
    folded = ascii::lower_case(name);
    name = folded;
  }
  auto const parts = split_name(name);
  if (!parts || parts->parts.empty()) return suggestions;
  std::vector<Candidate> candidates = candidates_for(vocabulary, *parts, bare_name(name));
  std::size_t const indices = index_count(*parts);
  put_in_order(candidates, vocabulary, indices);
  drop_arbitrary(candidates);
  suggestions.names.reserve(std::min(candidates.size(), most_suggestions));
  for (Candidate const& candidate : candidates) {
    if (suggestions.names.size() == most_suggestions) break;
    auto suggestion = with_indices(vocabulary.rows[candidate.name], *parts);
    if (!suggestion) continue;
    if (suggestions.names.empty()) {
      suggestions.is_close = candidate.slip <= Slip::two_letters;
      suggestions.is_former_name = candidate.slip == Slip::former_name;
      suggestions.is_certain =
          &candidate == &candidates.front() && is_certain(candidates, vocabulary, indices);
    }
    suggestions.names.push_back(std::move(*suggestion));
  }
  return suggestions;
}

NameSuggestions suggest_names(std::string_view name) {
  return suggest_names(built_in_vocabulary(), name);
}

std::vector<std::string_view> suggest_symbols(Parameter const& parameter, std::string_view word) {
  if (word.size() > longest_compared) return {};
  std::string const folded = ascii::lower_case(word);
  std::vector<std::pair<std::size_t, std::string_view>> near;
  for (Symbol const& symbol : parameter.symbols) {
    if (auto const distance = symbol_distance(folded, ascii::lower_case(symbol.word))) {
      near.emplace_back(*distance, symbol.word);
    }
  }
  std::stable_sort(near.begin(), near.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
  std::vector<std::string_view> suggestions;
  for (auto const& [distance, symbol] : near) {
    if (suggestions.size() < most_suggestions) suggestions.push_back(symbol);
  }
  return suggestions;
}

}  // namespace axisc::schema
