#include "schema/part_comparison.hpp"

#include "schema/edit_distance.hpp"

#include <algorithm>
#include <utility>

namespace axisc::schema {

bool resembles(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (a.size() < shortest_beginning) return false;
  std::size_t const at = b.find(a);
  if (at == std::string_view::npos) return false;
  std::size_t const end = at + a.size();
  return (at == 0 || b[at - 1] == '_') && (end == b.size() || b[end] == '_');
}

PartComparison::PartComparison(Vocabulary const& vocabulary, std::string_view given)
    : vocabulary_(vocabulary),
      given_(given),
      letters_(letter_sets_of(given).letters),
      limit_(tolerable_distance(given.size())),
      costs_(vocabulary.parts.size(), not_compared) {}

PartComparison::Result PartComparison::with(std::size_t part) {
  std::uint8_t const cost = cost_of(part);
  if (cost == unlike) return {.agrees = false, .cost = std::nullopt};
  if (cost == resembling) return {.agrees = false, .cost = resembling_part};
  return {.agrees = true, .cost = cost};
}

std::uint8_t PartComparison::cost_of(std::size_t part) {
  std::uint8_t& cost = costs_[part];
  if (cost == not_compared) cost = compare(part);
  return cost;
}

std::uint8_t PartComparison::compare(std::size_t part) const {
  Letters const wanted = vocabulary_.letters_of_parts[part];
  std::string_view const known = vocabulary_.parts[part];
  bool const is_as_long = given_.size() <= known.size() + limit_ && known.size() <= given_.size() + limit_;
  if (is_as_long && !certainly_beyond(letters_, wanted, limit_)) {
    std::size_t const slips = edit_distance(given_, known, limit_);
    if (slips <= limit_) return static_cast<std::uint8_t>(slips);
  }
  return may_contain_one_another(letters_, wanted) && resembles(given_, known) ? resembling : unlike;
}

std::optional<std::size_t> part_distance(std::vector<PartComparison>& given,
                                         std::span<std::uint32_t const> known) {
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

}  // namespace axisc::schema
