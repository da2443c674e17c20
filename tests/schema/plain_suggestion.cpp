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

constexpr std::size_t missing_part = 2;
constexpr std::size_t foreign_part = 4;

struct Meant {
  std::size_t cost;
  std::size_t index_difference;
  std::size_t text_distance;
  Parameter const* parameter;
  friend bool operator<(Meant const& a, Meant const& b) {
    return std::tie(a.cost, a.index_difference, a.text_distance, a.parameter) <
           std::tie(b.cost, b.index_difference, b.text_distance, b.parameter);
  }
};

std::string without_brackets(std::string_view pattern) {
  std::string bare(pattern);
  std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
  return bare;
}

std::vector<std::string> parts_of(std::string const& bare) {
  std::vector<std::string> parts;
  for (std::string_view rest = bare; !rest.empty();) parts.emplace_back(take_part(rest));
  return parts;
}

std::size_t slips(std::string_view given, std::string_view wanted) {
  return edit_distance(given, wanted, tolerable_distance(given.size()));
}

bool agrees(std::string_view given, std::string_view wanted) {
  return slips(given, wanted) <= tolerable_distance(given.size());
}

/// One is whole words of the other.
bool resembles(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  std::size_t const at = b.find(a);
  if (a.size() < 3 || at == std::string_view::npos) return false;
  std::size_t const end = at + a.size();
  return (at == 0 || b[at - 1] == '_') && (end == b.size() || b[end] == '_');
}

std::optional<std::size_t> cost_by_parts(std::vector<std::string> const& given,
                                         std::vector<std::string> const& known) {
  if (!agrees(given.back(), known.back()) && !resembles(given.back(), known.back())) return std::nullopt;
  std::size_t const common = std::min(given.size(), known.size());
  std::size_t cost = missing_part * (std::max(given.size(), known.size()) - common);
  std::size_t agreeing = 0, foreign = 0;
  for (std::size_t i = 1; i <= common; ++i) {
    std::string const& part = given[given.size() - i];
    std::string const& wanted = known[known.size() - i];
    if (agrees(part, wanted)) {
      ++agreeing;
      cost += slips(part, wanted);
    } else if (resembles(part, wanted)) {
      cost += 2;
    } else {
      ++foreign;
      cost += foreign_part;
    }
  }
  if (foreign > 1 || 2 * agreeing < given.size()) return std::nullopt;
  return cost;
}

std::vector<std::uint32_t> indices_of_name(IndexedName const& name) {
  std::vector<std::uint32_t> indices;
  for (NamePart const& part : name.parts) {
    if (part.index) indices.push_back(*part.index);
  }
  return indices;
}

}  // namespace

std::vector<std::string> suggest_names_plainly(std::string_view name) {
  if (name.size() > longest_compared) return {};
  std::string const folded = ascii::lower_case(name);
  auto const split = split_name(folded);
  if (!split || split->parts.empty()) return {};
  std::string const bare = bare_name(folded);
  std::vector<std::string> const given = parts_of(bare);
  std::vector<std::uint32_t> const indices = indices_of_name(*split);

  std::vector<Meant> meant;
  for (Parameter const& parameter : parameters()) {
    std::string const known = without_brackets(parameter.name);
    auto cost = cost_by_parts(given, parts_of(known));
    std::size_t const distance = edit_distance(bare, known, bare.size() + known.size());
    if (distance <= tolerable_distance(bare.size())) {
      std::size_t const as_a_whole = distance <= 2 ? distance : distance + 2;
      cost = std::min(cost.value_or(as_a_whole), as_a_whole);
    }
    if (!cost) continue;
    std::size_t const wanted = parameter.index_count();
    std::size_t const difference =
        wanted > indices.size() ? wanted - indices.size() : indices.size() - wanted;
    meant.push_back({*cost, difference, distance, &parameter});
  }
  std::sort(meant.begin(), meant.end());
  std::size_t const best = meant.empty() ? 0 : meant.front().cost;
  std::erase_if(meant, [best](Meant const& each) { return each.cost > best + 1; });
  if (meant.size() > 2) {
    std::erase_if(meant, [&bare](Meant const& each) {
      return each.cost >= foreign_part && 2 * each.text_distance >= bare.size();
    });
  }

  std::vector<std::string> suggestions;
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
    if (fits && suggestions.size() < 3) suggestions.push_back(text);
  }
  return suggestions;
}

}  // namespace axisc::test
