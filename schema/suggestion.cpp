#include "schema/ascii.hpp"
#include "schema/catalogue.hpp"
#include "schema/edit_distance.hpp"
#include "schema/indexed_name.hpp"
#include "schema/vocabulary.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
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
/// Suggestions that are more than this worse than the best are left out.
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

/// Every slip adds or takes away one letter at most.
bool has_more_than(std::size_t limit, Letters letters) {
  for (; limit > 0 && letters != 0; --limit) letters &= letters - 1;
  return letters != 0;
}

inline bool is_certainly_beyond(Outline const& a, Outline const& b, std::size_t limit) {
  std::size_t const difference = a.size > b.size ? a.size - b.size : b.size - a.size;
  return difference > limit || has_more_than(limit, a.letters & ~b.letters) ||
         has_more_than(limit, b.letters & ~a.letters);
}

/// What one part of the given name has to do with the known parts, found out when it is asked for.
class PartComparison {
 public:
  PartComparison(Words const& words, std::string_view given)
      : words_(words),
        given_(given),
        outline_(given),
        limit_(tolerable_distance(given.size())),
        costs_(words_.size(), not_compared) {}

  struct Result {
    bool agrees;                      ///< but for some slips
    std::optional<std::size_t> cost;  ///< none where nothing is alike
  };

  /// with(part) has a cost.
  bool is_like(std::size_t part) { return cost_of(part) != unlike; }

  Result with(std::size_t part) {
    std::uint8_t const cost = cost_of(part);
    if (cost == unlike) return {.agrees = false, .cost = std::nullopt};
    if (cost == resembling) return {.agrees = false, .cost = resembling_part};
    return {.agrees = true, .cost = cost};
  }

 private:
  static constexpr std::uint8_t not_compared = 255;
  static constexpr std::uint8_t unlike = 254;
  static constexpr std::uint8_t resembling = 253;

  std::uint8_t cost_of(std::size_t part) {
    std::uint8_t& cost = costs_[part];
    if (cost == not_compared) cost = compare(part);
    return cost;
  }

  [[nodiscard]] std::uint8_t compare(std::size_t part) const {
    Outline const& wanted = words_.outlines[part];
    if (!is_certainly_beyond(outline_, wanted, limit_)) {
      std::size_t const slips = edit_distance(given_, words_.texts[part], limit_);
      if (slips <= limit_) return static_cast<std::uint8_t>(slips);
    }
    // A whole word of the other brings no letter that the other has not.
    bool const contained =
        (outline_.letters & ~wanted.letters) == 0 || (wanted.letters & ~outline_.letters) == 0;
    return contained && resembles(given_, words_.texts[part]) ? resembling : unlike;
  }

  Words const& words_;
  std::string_view given_;
  Outline outline_;
  std::size_t limit_;
  std::vector<std::uint8_t> costs_;
};

/// Compares the parts of two names from the last one on, which is alike. None when they have too little in common.
std::optional<std::size_t> part_distance(std::vector<PartComparison>& given,
                                         std::vector<std::size_t> const& known) {
  std::size_t const common = std::min(given.size(), known.size());
  std::size_t cost = missing_part * (std::max(given.size(), known.size()) - common);
  std::size_t agreeing = 0;
  std::size_t foreign = 0;
  for (std::size_t i = 1; i <= common; ++i) {
    auto const part = given[given.size() - i].with(known[known.size() - i]);
    cost += part.cost.value_or(foreign_part);
    agreeing += part.agrees ? 1 : 0;
    foreign += part.cost ? 0 : 1;
  }
  if (foreign > 1 || 2 * agreeing < given.size()) return std::nullopt;
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

/// A name that may be meant: for its quantity, for its letters as a whole, or for both.
struct Resemblance {
  std::size_t name = 0;
  bool is_this_quantity = false;
  bool is_far_off = true;
};

/// Each name once that is worth a comparison. The last part says which quantity is meant.
std::vector<Resemblance> resemblances(Vocabulary const& vocabulary, PartComparison& last_part,
                                      Outline const& outline, std::size_t slip_limit) {
  std::vector<Resemblance> found;
  std::vector<std::uint32_t> place(vocabulary.names.size(), 0);  // index + 1 into `found`
  for (std::size_t const part : vocabulary.last_parts) {
    if (!last_part.is_like(part)) continue;
    for (std::size_t const name : vocabulary.names_with[part]) {
      found.push_back({.name = name, .is_this_quantity = true});
      place[name] = static_cast<std::uint32_t>(found.size());
    }
  }
  std::size_t const shortest = outline.size - std::min(outline.size, slip_limit);
  std::size_t const end = std::min(outline.size + slip_limit + 1, vocabulary.names_of_size.size());
  for (std::size_t size = shortest; size < end; ++size) {
    for (std::size_t const name : vocabulary.names_of_size[size]) {
      if (is_certainly_beyond(outline, vocabulary.names.outlines[name], slip_limit)) continue;
      if (place[name] == 0) {
        found.push_back({.name = name, .is_far_off = false});
      } else {
        found[place[name] - 1].is_far_off = false;
      }
    }
  }
  return found;
}

/// The candidates that are not much worse than the best, the best first.
std::vector<Candidate> candidates_for(Vocabulary const& vocabulary, IndexedName const& name) {
  std::string const bare = bare_name(name);
  Outline const outline(bare);
  std::size_t const slip_limit = tolerable_distance(bare.size());
  std::vector<PartComparison> parts;
  parts.reserve(name.parts.size());
  for (NamePart const& part : name.parts) parts.emplace_back(vocabulary.parts, part.name);

  std::vector<Candidate> candidates;
  Words const& known = vocabulary.names;
  std::size_t best = std::numeric_limits<std::size_t>::max() - tolerance_to_best;
  for (Resemblance const& alike : resemblances(vocabulary, parts.back(), outline, slip_limit)) {
    auto cost = alike.is_this_quantity ? part_distance(parts, vocabulary.parts_of[alike.name]) : std::nullopt;
    std::size_t const slips =
        alike.is_far_off ? slip_limit + 1 : edit_distance(bare, known.texts[alike.name], slip_limit);
    if (slips <= slip_limit) {
      std::size_t const whole_cost = slips <= few_slips ? slips : slips + another_word;
      cost = std::min(cost.value_or(whole_cost), whole_cost);
    }
    if (!cost) continue;
    best = std::min(best, *cost);
    if (*cost > best + tolerance_to_best) continue;
    candidates.push_back({.cost = *cost, .text_distance = slips, .parameter = &vocabulary.rows[alike.name]});
  }
  std::erase_if(candidates,
                [best](Candidate const& candidate) { return candidate.cost > best + tolerance_to_best; });

  std::size_t const indices = given_indices(name).size();
  for (Candidate& candidate : candidates) {
    std::size_t const wanted = candidate.parameter->index_count();
    candidate.index_difference = wanted > indices ? wanted - indices : indices - wanted;
    if (candidate.text_distance <= slip_limit) continue;
    auto const row = static_cast<std::size_t>(candidate.parameter - vocabulary.rows.data());
    std::string const& text = known.texts[row];
    candidate.text_distance = edit_distance(bare, text, bare.size() + text.size());
  }
  std::sort(candidates.begin(), candidates.end(), is_better);
  return candidates;
}

/// A quantity that many families have (`enable`) says nothing about the family that was meant, so of those only the ones
/// whose family is spelled alike stay.
void drop_arbitrary(std::vector<Candidate>& candidates, std::size_t name_size) {
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

std::vector<std::string> suggest_names(Vocabulary const& vocabulary, std::string_view name) {
  if (name.size() > longest_compared) return {};
  std::string const folded = lower_case(name);
  auto const parts = split_name(folded);
  if (!parts || parts->parts.empty()) return {};
  std::vector<Candidate> candidates = candidates_for(vocabulary, *parts);
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

std::vector<std::string> suggest_names(std::string_view name) {
  static Vocabulary const built_in = take_apart(parameters());
  return suggest_names(built_in, name);
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
