#include "schema/name_candidates.hpp"

#include "schema/edit_distance.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace axisc::schema {
namespace {

/// Letters of a word: fewer begin too many words.
constexpr std::size_t shortest_beginning = 3;

using Parts = std::vector<std::string_view>;

/// True for `ipc` and `improved_position_control`.
bool abbreviates(std::string_view part, std::string_view words) {
  if (part.size() < shortest_beginning) return false;
  std::size_t at = 0;
  for (char const initial : part) {
    if (at >= words.size() || words[at] != initial) return false;
    std::size_t const next = words.find('_', at);
    at = next == std::string_view::npos ? words.size() : next + 1;
  }
  return at == words.size();
}

class Search {
 public:
  Search(Vocabulary const& vocabulary, IndexedName const& name, std::string_view bare)
      : vocabulary_(vocabulary), bare_(bare) {
    given_.reserve(name.parts.size());
    for (NamePart const& part : name.parts) given_.push_back(part.name);
  }

  std::vector<Candidate> run() && {
    find_slips_of_the_pen();
    // One letter explains a name well enough, and most names are mistyped so.
    if (best_ > static_cast<std::size_t>(Slip::one_letter)) {
      find_whole_parts();
      find_swaps();
      find_in_family();
    }
    std::erase_if(found_, [this](Candidate const& candidate) {
      return static_cast<std::size_t>(candidate.slip) > best_ + 1;
    });
    return std::move(found_);
  }

 private:
  void find_slips_of_the_pen() {
    constexpr std::size_t most_slips = slips_of_the_pen(SIZE_MAX);
    for_each_of_like_letters(vocabulary_, bare_, most_slips, [&](std::size_t name) {
      std::size_t const slips = edit_distance(bare_, vocabulary_.names[name], most_slips);
      if (slips > most_slips) return;
      if (slips == 1) {
        add(name, Slip::one_letter);
      } else if (auto const part = only_different_part(given_, name)) {
        std::size_t const length = std::max(given_[*part].size(), part_of(name, *part).size());
        if (slips <= slips_of_the_pen(length)) add(name, Slip::two_letters);
      }
    });
  }

  /// Finds missing parts in names with the same last part.
  void find_whole_parts() {
    auto const last = find_text(given_.back(), vocabulary_.parts, vocabulary_.places_of_parts);
    if (!last) return;
    for (std::uint32_t const name : vocabulary_.names_ending_in[*last]) {
      if (auto const missing = missing_part(name)) {
        add(name, Slip::whole_part, *missing != 0);
      } else if (auto const part = only_different_part(given_, name)) {
        if (abbreviates(given_[*part], part_of(name, *part))) {
          add(name, Slip::whole_part);
        } else if (resembles(given_[*part], part_of(name, *part))) {
          add(name, Slip::resemblance);
        }
      }
    }
  }

  void find_swaps() {
    for (std::size_t i = 0; i + 1 < given_.size(); ++i) {
      Parts swapped = given_;
      std::swap(swapped[i], swapped[i + 1]);
      add_if_known(swapped, Slip::whole_part);
    }
    for (std::size_t i = 0; i < given_.size(); ++i) find_swapped_words(i);
  }

  void find_swapped_words(std::size_t part) {
    if (given_[part].find('_') == std::string_view::npos) return;
    Parts words;
    for (std::string_view rest = given_[part]; !rest.empty();) {
      std::size_t const end = std::min(rest.find('_'), rest.size());
      words.push_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::size_t j = i + 1; j < words.size(); ++j) {
        std::swap(words[i], words[j]);
        std::string joined;
        for (std::string_view const word : words) joined.append(joined.empty() ? "" : "_").append(word);
        std::swap(words[i], words[j]);
        if (joined == given_[part] || !find_text(joined, vocabulary_.parts, vocabulary_.places_of_parts)) {
          continue;
        }
        Parts swapped = given_;
        swapped[part] = joined;
        add_if_known(swapped, Slip::whole_part);
      }
    }
  }

  void add_if_known(Parts const& wanted, Slip slip) {
    auto const last = find_text(wanted.back(), vocabulary_.parts, vocabulary_.places_of_parts);
    if (!last) return;
    for (std::uint32_t const name : vocabulary_.names_ending_in[*last]) {
      bool const is_this =
          vocabulary_.parts_of[name].size() == wanted.size() && !first_difference(wanted, name);
      if (is_this) add(name, slip);
    }
  }

  /// Names in the family of the given one, of which the last part is alike.
  void find_in_family() {
    std::string_view const last = given_.back();
    std::string_view const family_name = bare_.substr(0, bare_.size() - last.size());
    auto const family = find_text(family_name, vocabulary_.families, vocabulary_.places_of_families);
    if (family_name.empty() || !family) return;
    std::size_t const limit = tolerable_distance(last.size());
    Letters const letters = letter_sets_of(last).letters;
    Groups const& groups = vocabulary_.names_of_family;
    for (std::size_t i = groups.starts[*family]; i < groups.starts[*family + 1]; ++i) {
      Letters const wanted = vocabulary_.letters_by_family[i];
      std::uint32_t const name = groups.numbers[i];
      std::string_view const known = vocabulary_.parts[vocabulary_.parts_of[name].back()];
      if (may_contain_one_another(letters, wanted) && resembles(last, known)) {
        add(name, Slip::resemblance);
      } else if (!certainly_beyond(letters, wanted, limit) && edit_distance(last, known, limit) <= limit) {
        add(name, Slip::more_letters);
      }
    }
  }

  [[nodiscard]] std::string_view part_of(std::size_t name, std::size_t part) const {
    return vocabulary_.parts[vocabulary_.parts_of[name][part]];
  }

  /// The first of the parts that differs, of so many as the shorter name has.
  [[nodiscard]] std::optional<std::size_t> first_difference(Parts const& given, std::size_t name,
                                                            std::size_t from = 0) const {
    std::size_t const common = std::min(given.size(), vocabulary_.parts_of[name].size());
    for (std::size_t i = from; i < common; ++i) {
      if (given[i] != part_of(name, i)) return i;
    }
    return std::nullopt;
  }

  /// None where the names have not as many parts, or differ in none or several.
  [[nodiscard]] std::optional<std::size_t> only_different_part(Parts const& given, std::size_t name) const {
    if (vocabulary_.parts_of[name].size() != given.size()) return std::nullopt;
    auto const part = first_difference(given, name);
    return part && first_difference(given, name, *part + 1) ? std::nullopt : part;
  }

  /// The part of the known name that the given one, which has all others, lacks.
  [[nodiscard]] std::optional<std::size_t> missing_part(std::size_t name) const {
    std::size_t const count = vocabulary_.parts_of[name].size();
    if (count != given_.size() + 1) return std::nullopt;
    std::size_t const missing = first_difference(given_, name).value_or(given_.size());
    for (std::size_t i = missing; i < given_.size(); ++i) {
      if (given_[i] != part_of(name, i + 1)) return std::nullopt;
    }
    return missing;
  }

  void add(std::size_t name, Slip slip, bool begins_alike = true) {
    best_ = std::min(best_, static_cast<std::size_t>(slip));
    auto const known = std::find_if(found_.begin(), found_.end(),
                                    [name](Candidate const& candidate) { return candidate.name == name; });
    if (known != found_.end()) {
      known->slip = std::min(known->slip, slip);
      return;
    }
    std::string_view const text = vocabulary_.names[name];
    found_.push_back({.name = name,
                      .slip = slip,
                      .begins_alike = begins_alike,
                      .text_distance = edit_distance(bare_, text, bare_.size() + text.size())});
  }

  Vocabulary const& vocabulary_;
  Parts given_;
  std::string_view bare_;
  std::size_t best_ = static_cast<std::size_t>(Slip::more_letters);
  std::vector<Candidate> found_;
};

/// The row that once had this name.
std::optional<std::size_t> row_once_called(std::span<Parameter const> rows, std::string_view name) {
  // Nearly all names are looked up in the built-in catalogue, of which few rows once had another name.
  static std::vector<std::size_t> const built_in = [] {
    std::vector<std::size_t> renamed;
    for (std::size_t i = 0; i < parameters().size(); ++i) {
      if (!parameters()[i].former_name.empty()) renamed.push_back(i);
    }
    return renamed;
  }();
  auto const is_called = [&](std::size_t row) { return rows[row].former_name == name; };
  if (rows.data() == parameters().data()) {
    auto const found = std::find_if(built_in.begin(), built_in.end(), is_called);
    return found == built_in.end() ? std::nullopt : std::optional(*found);
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (is_called(row)) return row;
  }
  return std::nullopt;
}

}  // namespace

bool resembles(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (a.size() < shortest_beginning) return false;
  std::size_t const at = b.find(a);
  if (at == std::string_view::npos) return false;
  std::size_t const end = at + a.size();
  return (at == 0 || b[at - 1] == '_') && (end == b.size() || b[end] == '_');
}

std::vector<Candidate> candidates_for(Vocabulary const& vocabulary, IndexedName const& name,
                                      std::string_view bare) {
  if (auto const row = row_once_called(vocabulary.rows, bare)) {
    return {{.name = *row, .slip = Slip::former_name}};
  }
  return Search(vocabulary, name, bare).run();
}

}  // namespace axisc::schema
