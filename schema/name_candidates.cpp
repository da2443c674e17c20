#include "schema/name_candidates.hpp"

#include "schema/edit_distance.hpp"
#include "schema/part_comparison.hpp"

#include <algorithm>
#include <utility>

namespace axisc::schema {
namespace {

/// The search for names of which all but one slip is known already. What costs no more than few_slips has few slips as
/// a whole, or lacks exactly one part, or has exactly one that resembles: everything else costs more.
class CloseSearch {
 public:
  CloseSearch(Vocabulary const& vocabulary, IndexedName const& name, std::string_view bare)
      : vocabulary_(vocabulary), given_(name.parts), bare_(bare) {
    constexpr std::size_t usual_candidates = 8;
    found_.reserve(usual_candidates);
  }

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
    if (auto const part = find_text(last, vocabulary_.parts, vocabulary_.places_of_parts)) {
      for (std::uint32_t const name : vocabulary_.names_ending_in[*part]) {
        if (lacks_one_part(name) || one_part_resembles(name)) add(name);
      }
    }
    if (given_.size() < 2) return;
    std::string_view const family_name = bare_.substr(0, bare_.size() - last.size());
    if (auto const family = find_text(family_name, vocabulary_.families, vocabulary_.places_of_families)) {
      find_other_quantities(*family);
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
    return different != known.size() &&
           only_resembles(given_[different].name, vocabulary_.parts[known[different]]);
  }

  [[nodiscard]] static bool only_resembles(std::string_view part, std::string_view wanted) {
    std::size_t const limit = tolerable_distance(part.size());
    return resembles(part, wanted) && edit_distance(part, wanted, limit) > limit;
  }

  /// Names in the family of the given one, of which the last part resembles.
  void find_other_quantities(std::size_t family) {
    std::string_view const last = given_.back().name;
    Letters const letters = letter_sets_of(last).letters;
    Groups const& groups = vocabulary_.names_of_family;
    for (std::size_t i = groups.starts[family]; i < groups.starts[family + 1]; ++i) {
      Letters const wanted = vocabulary_.letters_by_family[i];
      if (!may_contain_one_another(letters, wanted)) continue;
      std::uint32_t const name = groups.numbers[i];
      if (only_resembles(last, vocabulary_.parts[vocabulary_.parts_of[name].back()])) add(name);
    }
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
