#include "schema/name_candidates.hpp"

#include "schema/edit_distance.hpp"
#include "schema/part_comparison.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace axisc::schema {
namespace {

/// The search for names of which all but one slip is known already. What costs no more than few_slips has few slips as
/// a whole, or lacks exactly one part, or has exactly one that resembles: everything else costs more.
class CloseSearch {
 public:
  CloseSearch(Vocabulary const& vocabulary, IndexedName const& name, std::string_view bare)
      : vocabulary_(vocabulary), given_(name.parts), bare_(bare) {}

  /// The lowest cost; more than few_slips where nothing is found.
  std::size_t find_few_slips() {
    std::size_t best = few_slips + 1;
    for_each_of_like_letters(vocabulary_, bare_, few_slips, [&](std::size_t name) {
      std::size_t const slips = edit_distance(bare_, vocabulary_.names[name], few_slips);
      if (slips > few_slips) return;
      found_.push_back({.name = name, .cost = slips, .text_distance = slips});
      best = std::min(best, slips);
    });
    return best;
  }

  void find_other_parts() {
    std::string_view const last = given_.back().name;
    auto const part = std::lower_bound(vocabulary_.parts.begin(), vocabulary_.parts.end(), last);
    if (part != vocabulary_.parts.end() && *part == last) {
      for (std::uint32_t const name :
           vocabulary_.names_ending_in[static_cast<std::size_t>(part - vocabulary_.parts.begin())]) {
        if (lacks_one_part(name) || one_part_resembles(name)) add(name);
      }
    }
    std::string_view const family = bare_.substr(0, bare_.size() - last.size());
    Letters const letters = letters_of(last);
    auto const& names = vocabulary_.names;
    auto const& alphabetic = vocabulary_.alphabetic;
    auto const begin = std::partition_point(alphabetic.begin(), alphabetic.end(),
                                            [&](std::uint32_t name) { return names[name] < family; });
    auto const end = std::partition_point(
        begin, alphabetic.end(), [&](std::uint32_t name) { return names[name].starts_with(family); });
    for (std::uint32_t const name : std::span(begin, end)) {
      Letters const wanted = vocabulary_.letters_of_parts[vocabulary_.parts_of[name].back()];
      // A whole word of the other brings no letter that the other has not.
      bool const contained = (letters & ~wanted) == 0 || (wanted & ~letters) == 0;
      if (contained && one_part_resembles(name)) add(name);
    }
  }

  [[nodiscard]] std::vector<Candidate> take() && { return std::move(found_); }

 private:
  [[nodiscard]] bool lacks_one_part(std::size_t name) const {
    auto const known = vocabulary_.parts_of[name];
    std::size_t const common = std::min(given_.size(), known.size());
    if (std::max(given_.size(), known.size()) != common + 1) return false;
    for (std::size_t i = 1; i <= common; ++i) {
      if (given_[given_.size() - i].name != vocabulary_.parts[known[known.size() - i]]) return false;
    }
    return 2 * common >= given_.size();
  }

  [[nodiscard]] bool one_part_resembles(std::size_t name) const {
    auto const known = vocabulary_.parts_of[name];
    if (known.size() != given_.size() || known.size() < 2) return false;
    std::size_t different = known.size();
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (given_[i].name == vocabulary_.parts[known[i]]) continue;
      if (different != known.size()) return false;
      different = i;
    }
    if (different == known.size()) return false;
    std::string_view const part = given_[different].name;
    std::string_view const wanted = vocabulary_.parts[known[different]];
    std::size_t const limit = tolerable_distance(part.size());
    return resembles(part, wanted) && edit_distance(part, wanted, limit) > limit;
  }

  void add(std::size_t name) {
    bool const is_known = std::any_of(found_.begin(), found_.end(),
                                      [name](Candidate const& candidate) { return candidate.name == name; });
    if (is_known) return;
    std::string_view const text = vocabulary_.names[name];
    found_.push_back({.name = name,
                      .cost = resembling_part,
                      .text_distance = edit_distance(bare_, text, bare_.size() + text.size())});
  }

  Vocabulary const& vocabulary_;
  std::vector<NamePart> const& given_;
  std::string_view bare_;
  std::vector<Candidate> found_;
};

static_assert(resembling_part == few_slips && missing_part == few_slips && foreign_part > few_slips);

}  // namespace

std::vector<Candidate> candidates_for(Vocabulary const& vocabulary, IndexedName const& name,
                                      std::string_view bare) {
  if (tolerable_distance(bare.size()) < few_slips) return distant_candidates(vocabulary, name, bare);
  CloseSearch search(vocabulary, name, bare);
  std::size_t const best = search.find_few_slips();
  if (best + tolerance_to_best > few_slips) return distant_candidates(vocabulary, name, bare);
  if (best + tolerance_to_best == few_slips) search.find_other_parts();
  std::vector<Candidate> candidates = std::move(search).take();
  std::erase_if(candidates,
                [best](Candidate const& candidate) { return candidate.cost > best + tolerance_to_best; });
  return candidates;
}

}  // namespace axisc::schema
