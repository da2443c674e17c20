#include "schema/plain_suggestion.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/catalogue.hpp"
#include "schema/edit_distance.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

namespace axisc::test {
namespace {

using namespace schema;

struct Meant {
  int cost;
  std::size_t index_difference;
  std::size_t text_distance;
  Parameter const* parameter;
  bool begins_alike;
  friend bool operator<(Meant const& a, Meant const& b) {
    return std::tie(a.cost, a.index_difference, a.text_distance, a.parameter) <
           std::tie(b.cost, b.index_difference, b.text_distance, b.parameter);
  }
};

using Texts = std::vector<std::string>;

std::string without_brackets(std::string_view pattern) {
  std::string bare(pattern);
  std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
  return bare;
}

Texts split(std::string const& text, char mark) {
  Texts pieces(1);
  for (char const byte : text) {
    if (byte == mark) {
      pieces.emplace_back();
    } else {
      pieces.back() += byte;
    }
  }
  return pieces;
}

std::string join(Texts const& pieces, char mark) {
  std::string text;
  for (std::size_t i = 0; i < pieces.size(); ++i) text += (i == 0 ? "" : std::string(1, mark)) + pieces[i];
  return text;
}

/// One is whole words of the other.
bool is_words_of(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  std::size_t const at = b.find(a);
  if (a.size() < 3 || at == std::string_view::npos) return false;
  std::size_t const end = at + a.size();
  return (at == 0 || b[at - 1] == '_') && (end == b.size() || b[end] == '_');
}

bool is_initials_of(std::string const& part, std::string const& words) {
  std::string initials;
  for (std::string const& word : split(words, '_')) initials += word.substr(0, 1);
  return part.size() >= 3 && part == initials;
}

/// The name with any two neighbouring parts, or any two words of a part, swapped.
Texts swapped(Texts const& given) {
  Texts names;
  for (std::size_t i = 0; i + 1 < given.size(); ++i) {
    Texts parts = given;
    std::swap(parts[i], parts[i + 1]);
    names.push_back(join(parts, '.'));
  }
  for (std::size_t part = 0; part < given.size(); ++part) {
    Texts const words = split(given[part], '_');
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::size_t j = i + 1; j < words.size(); ++j) {
        Texts parts = given;
        Texts other = words;
        std::swap(other[i], other[j]);
        parts[part] = join(other, '_');
        names.push_back(join(parts, '.'));
      }
    }
  }
  return names;
}

std::optional<int> cost_of(Texts const& given, Texts const& known, bool& begins_alike) {
  std::string const bare = join(given, '.');
  std::string const wanted = join(known, '.');
  begins_alike = true;
  if (bare == wanted) return std::nullopt;
  std::size_t const slips = edit_distance(bare, wanted, 10);
  if (slips == 1) return 1;
  for (std::size_t missing = 0; missing < known.size(); ++missing) {
    Texts shorter = known;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(missing));
    if (shorter != given || given.back() != known.back()) continue;
    begins_alike = missing != 0;
    return 1;
  }
  for (std::string const& name : swapped(given)) {
    if (name == wanted) return 1;
  }
  if (given.size() != known.size()) return std::nullopt;
  Texts different;
  std::size_t place = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] == known[i]) continue;
    place = i;
    different.push_back(given[i]);
  }
  if (different.size() != 1) return std::nullopt;
  bool const is_last = place + 1 == given.size();
  if (!is_last && is_initials_of(given[place], known[place])) return 1;
  if (slips == 2 && std::max(given[place].size(), known[place].size()) >= 8) return 2;
  if (given.size() > 1 && is_words_of(given[place], known[place])) return 3;
  std::size_t const limit = tolerable_distance(given[place].size());
  if (given.size() > 1 && is_last && edit_distance(given[place], known[place], limit) <= limit) return 4;
  return std::nullopt;
}

std::vector<std::uint32_t> indices_of_name(IndexedName const& name) {
  std::vector<std::uint32_t> indices;
  for (NamePart const& part : name.parts) {
    if (part.index) indices.push_back(*part.index);
  }
  return indices;
}

}  // namespace

PlainSuggestions suggest_names_plainly(std::string_view name) {
  if (name.size() > longest_compared) return {};
  std::string const folded = ascii::lower_case(name);
  auto const parts = split_name(folded);
  if (!parts || parts->parts.empty()) return {};
  Texts const given = split(bare_name(folded), '.');
  std::string const bare = join(given, '.');
  std::vector<std::uint32_t> const indices = indices_of_name(*parts);

  std::vector<Meant> meant;
  bool renamed = false;
  for (Parameter const& parameter : parameters()) {
    std::string const known = without_brackets(parameter.name);
    bool begins_alike = true;
    auto cost = cost_of(given, split(known, '.'), begins_alike);
    if (parameter.former_name == bare) {
      cost = 0;
      renamed = true;
    }
    if (!cost) continue;
    std::size_t const distance = edit_distance(bare, known, bare.size() + known.size());
    std::size_t const wanted = parameter.index_count();
    std::size_t const difference =
        wanted > indices.size() ? wanted - indices.size() : indices.size() - wanted;
    meant.push_back({*cost, difference, distance, &parameter, begins_alike});
  }
  std::sort(meant.begin(), meant.end());
  auto const is_letter = [](Meant const& each) { return each.text_distance == 1; };
  if (std::any_of(meant.begin(), meant.end(), is_letter)) {
    std::erase_if(meant, [](Meant const& each) { return each.text_distance > 2; });
  }
  int const best = meant.empty() ? 0 : meant.front().cost;
  std::erase_if(meant, [&](Meant const& each) { return renamed ? each.cost != 0 : each.cost > best + 1; });
  auto const lacks_beginning = [](Meant const& each) { return !each.begins_alike; };
  if (std::count_if(meant.begin(), meant.end(), lacks_beginning) > 2) std::erase_if(meant, lacks_beginning);

  PlainSuggestions suggestions;
  for (Meant const& each : meant) {
    std::string text;
    std::size_t position = 0;
    bool fits = true;
    for (char const byte : each.parameter->name) {
      text += byte;
      if (byte != '[') continue;
      std::uint32_t const index = position < indices.size() ? indices[position] : 0;
      fits = fits && index < each.parameter->array.at(position++);
      text += std::to_string(index);
    }
    if (!fits) continue;
    if (&each == &meant.front()) {
      suggestions.certain = each.cost <= 2 && each.begins_alike && each.index_difference == 0;
      for (Meant const& other : meant) {
        bool const is_other =
            without_brackets(other.parameter->name) != without_brackets(each.parameter->name);
        if (is_other && other.cost < 2 * each.cost) suggestions.certain = false;
      }
    }
    if (suggestions.names.size() < 3) suggestions.names.push_back(text);
  }
  return suggestions;
}

}  // namespace axisc::test
