#include "schema/edit_distance.hpp"
#include "schema/name_candidates.hpp"
#include "schema/part_comparison.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace axisc::schema {
namespace {

/// What more than few_slips in the name as a whole cost in addition.
constexpr std::size_t another_word = 2;

/// A name that may be meant: for its quantity, for its letters as a whole, or for both.
struct Resemblance {
  std::size_t name = 0;
  bool is_this_quantity = false;
  bool is_far_off = true;
};

/// Each name once that is worth a comparison. The last part says which quantity is meant.
std::vector<Resemblance> resemblances(Vocabulary const& vocabulary, PartComparison& last_part,
                                      std::string_view bare, std::size_t slip_limit) {
  std::vector<Resemblance> found;
  std::vector<std::uint32_t> place(vocabulary.names.size(), 0);  // index + 1 into `found`
  for (std::size_t part = 0; part < vocabulary.parts.size(); ++part) {
    if (!last_part.is_like(part)) continue;
    for (std::size_t const name : vocabulary.names_ending_in[part]) {
      found.push_back({.name = name, .is_this_quantity = true});
      place[name] = static_cast<std::uint32_t>(found.size());
    }
  }
  for_each_of_like_letters(vocabulary, bare, slip_limit, [&](std::size_t name) {
    if (place[name] == 0) {
      found.push_back({.name = name, .is_far_off = false});
    } else {
      found[place[name] - 1].is_far_off = false;
    }
  });
  return found;
}

}  // namespace

std::vector<Candidate> distant_candidates(Vocabulary const& vocabulary, IndexedName const& name,
                                          std::string_view bare) {
  std::size_t const slip_limit = tolerable_distance(bare.size());
  std::vector<PartComparison> parts;
  parts.reserve(name.parts.size());
  for (NamePart const& part : name.parts) parts.emplace_back(vocabulary, part.name);

  std::vector<Candidate> candidates;
  std::size_t best = std::numeric_limits<std::size_t>::max() - tolerance_to_best;
  for (Resemblance const& alike : resemblances(vocabulary, parts.back(), bare, slip_limit)) {
    std::optional<std::size_t> cost;
    if (alike.is_this_quantity) cost = part_distance(parts, vocabulary.parts_of[alike.name]);
    std::size_t const slips =
        alike.is_far_off ? slip_limit + 1 : edit_distance(bare, vocabulary.names[alike.name], slip_limit);
    if (slips <= slip_limit) {
      std::size_t const whole_cost = slips <= few_slips ? slips : slips + another_word;
      cost = cost ? std::min(*cost, whole_cost) : whole_cost;
    }
    if (!cost) continue;
    best = std::min(best, *cost);
    if (*cost > best + tolerance_to_best) continue;
    candidates.push_back({.name = alike.name, .cost = *cost, .text_distance = slips});
  }
  std::erase_if(candidates,
                [best](Candidate const& candidate) { return candidate.cost > best + tolerance_to_best; });
  for (Candidate& candidate : candidates) {
    if (candidate.text_distance <= slip_limit) continue;
    std::string_view const text = vocabulary.names[candidate.name];
    candidate.text_distance = edit_distance(bare, text, bare.size() + text.size());
  }
  return candidates;
}

}  // namespace axisc::schema
