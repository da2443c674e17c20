#include "schema/ascii.hpp"
#include "schema/catalogue.hpp"
#include "schema/edit_distance.hpp"
#include "schema/indexed_name.hpp"

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
/// Up to this many slips in a name as a whole count as such, wherever they are: a dot may stand for an underscore. More
/// are worth `another_word` in addition.
constexpr std::size_t few_slips = 2;
constexpr std::size_t another_word = 2;
/// Of a symbol: fewer letters begin too many words.
constexpr std::size_t shortest_beginning = 3;

// What the differences between a name and a known one weigh. A slip of the pen is 1.
constexpr std::size_t resembling_part = 2;  ///< `fir` for `filter_fir`
constexpr std::size_t missing_part = 2;     ///< the part is not there at all
constexpr std::size_t foreign_part = 4;     ///< another word: the parameter is known, but in another family
/// Suggestions that are this much worse than the best are left out.
constexpr std::size_t tolerance_to_best = 1;
/// Up to this many other families are worth naming whatever they are called.
constexpr std::size_t clear_families = 2;

/// True if the shorter word is one or several whole words of the longer: `filter` in `filter_fir`.
bool resembles(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (a.size() < shortest_beginning) return false;
  std::size_t const at = b.find(a);
  if (at == std::string_view::npos) return false;
  std::size_t const end = at + a.size();
  return (at == 0 || b[at - 1] == '_') && (end == b.size() || b[end] == '_');
}

/// A known name taken apart, in storage that is used again for the next one.
struct KnownName {
  std::string bare;
  std::vector<std::string_view> parts;

  void assign(std::string_view pattern) {
    bare.clear();
    parts.clear();
    for (char const byte : pattern) {
      if (byte != '[' && byte != ']') bare += byte;
    }
    for (std::string_view rest = bare; !rest.empty();) parts.push_back(take_part(rest));
  }
};

/// Compares the parts of two names from the last one on. None when they have too little in common.
std::optional<std::size_t> part_distance(IndexedName const& name,
                                         std::vector<std::string_view> const& known) {
  std::size_t const given_count = name.parts.size();
  std::size_t const common = std::min(given_count, known.size());
  std::size_t cost = missing_part * (std::max(given_count, known.size()) - common);
  std::size_t agreeing = 0;
  std::size_t foreign = 0;
  for (std::size_t i = 1; i <= common; ++i) {
    std::string_view const given = name.parts[given_count - i].name;
    std::string_view const wanted = known[known.size() - i];
    std::size_t const limit = tolerable_distance(given.size());
    std::size_t const slips = edit_distance(given, wanted, limit);
    if (slips <= limit) {
      cost += slips;
      ++agreeing;
    } else if (resembles(given, wanted)) {
      cost += resembling_part;
    } else if (i == 1) {
      return std::nullopt;  // the last part says which quantity is meant
    } else {
      cost += foreign_part;
      ++foreign;
    }
  }
  if (foreign > 1 || 2 * agreeing < given_count) return std::nullopt;
  return cost;
}

struct Candidate {
  std::size_t cost = 0;
  std::size_t index_difference = 0;  ///< one has more indices than the other
  std::size_t text_distance = 0;     ///< between the names as a whole
  Parameter const* parameter = nullptr;
};

bool is_better(Candidate const& a, Candidate const& b) {
  return std::tie(a.cost, a.index_difference, a.text_distance, a.parameter) <
         std::tie(b.cost, b.index_difference, b.text_distance, b.parameter);
}

std::vector<std::uint32_t> given_indices(IndexedName const& name) {
  std::vector<std::uint32_t> indices;
  for (NamePart const& part : name.parts) {
    if (part.index) indices.push_back(*part.index);
  }
  return indices;
}

std::vector<Candidate> candidates_for(IndexedName const& name) {
  std::string const bare = bare_name(name);
  std::size_t const indices = given_indices(name).size();
  std::size_t const slip_limit = tolerable_distance(bare.size());
  std::vector<Candidate> candidates;
  KnownName known;
  for (Parameter const& parameter : parameters()) {
    known.assign(parameter.name);
    auto cost = part_distance(name, known.parts);
    std::size_t const slips = edit_distance(bare, known.bare, slip_limit);
    if (slips <= slip_limit) {
      std::size_t const whole_cost = slips <= few_slips ? slips : slips + another_word;
      cost = std::min(cost.value_or(whole_cost), whole_cost);
    }
    if (!cost) continue;
    std::size_t const wanted = parameter.index_count();
    candidates.push_back({.cost = *cost,
                          .index_difference = wanted > indices ? wanted - indices : indices - wanted,
                          .text_distance = edit_distance(bare, known.bare, bare.size() + known.bare.size()),
                          .parameter = &parameter});
  }
  std::sort(candidates.begin(), candidates.end(), is_better);
  return candidates;
}

/// Leaves the best. A quantity that many families have (`enable`) says nothing about the family that was meant, so
/// of those only the ones whose family is spelled alike stay.
void drop_arbitrary(std::vector<Candidate>& candidates, std::size_t name_size) {
  if (candidates.empty()) return;
  std::size_t const worst = candidates.front().cost + tolerance_to_best;
  std::erase_if(candidates, [worst](Candidate const& candidate) { return candidate.cost > worst; });
  if (candidates.size() <= clear_families) return;
  std::erase_if(candidates, [name_size](Candidate const& candidate) {
    return candidate.cost >= foreign_part && 2 * candidate.text_distance >= name_size;
  });
}

/// The known name with the given indices; 0 where there are too few. None when one is out of range there.
std::optional<std::string> with_indices(Parameter const& parameter,
                                        std::vector<std::uint32_t> const& indices) {
  std::string name;
  std::size_t position = 0;
  for (char const byte : parameter.name) {
    name += byte;
    if (byte != '[') continue;
    std::uint32_t const index = position < indices.size() ? indices[position] : 0;
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
  if (word.size() >= shortest_beginning && (symbol.starts_with(word) || resembles(word, symbol))) {
    return limit + 1;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> suggest_names(std::string_view name) {
  if (name.size() > longest_compared) return {};
  std::string const folded = lower_case(name);
  auto const parts = split_name(folded);
  if (!parts) return {};
  std::vector<Candidate> candidates = candidates_for(*parts);
  drop_arbitrary(candidates, bare_name(*parts).size());
  std::vector<std::uint32_t> const indices = given_indices(*parts);
  std::vector<std::string> suggestions;
  for (Candidate const& candidate : candidates) {
    if (suggestions.size() == most_suggestions) break;
    if (auto suggestion = with_indices(*candidate.parameter, indices)) {
      suggestions.push_back(std::move(*suggestion));
    }
  }
  return suggestions;
}

std::vector<std::string_view> suggest_symbols(Parameter const& parameter, std::string_view word) {
  if (word.size() > longest_compared) return {};
  std::string const folded = lower_case(word);
  std::vector<std::pair<std::size_t, std::string_view>> near;
  for (Symbol const& symbol : parameter.symbols) {
    if (auto const distance = symbol_distance(folded, lower_case(symbol.word))) {
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
