#include "validator/engine/precedence.hpp"

#include "validator/engine/rule.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

/// Text, several axes, filters, parameters, any other.
int place_of_family(Code code) {
  switch (static_cast<std::uint16_t>(code) / 1000) {
    case 1: return 0;
    case 4: return 1;
    case 3: return 2;
    case 2: return 3;
    default: return 4;
  }
}

/// Every family has three places: before its rules, theirs, and after them.
int place_among_rules(Rule const& rule) {
  int const family = 3 * place_of_family(rule.code);
  switch (rule.precedence) {
    case Precedence::before_family: return family;
    case Precedence::of_family: break;
    case Precedence::after_family: return family + 2;
    case Precedence::after_text: return 2;
  }
  return family + 1;
}

auto order(Reported const& finding) {
  return std::make_tuple(finding.severity, place_among_rules(*finding.rule), finding.rule->code);
}

/// Sort key. Held separately because the findings themselves are far apart in memory, and packed into numbers
/// that are compared at once.
struct Key {
  std::uint64_t begin = 0;  ///< source and offset
  std::uint64_t end = 0;    ///< offset and code
  std::uint32_t number = 0;

  Key(Reported const& finding, std::uint32_t its_number)
      : begin(pair(static_cast<std::uint32_t>(finding.place.source), finding.place.span.begin)),
        end(pair(finding.place.span.end, static_cast<std::uint16_t>(finding.rule->code))),
        number(its_number) {}

  static std::uint64_t pair(std::uint32_t high, std::uint32_t low) {
    return std::uint64_t{high} << 32U | low;
  }
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(Key const&, Key const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Nearly every rule reports in the order of the list, so the findings of all rules are a few sorted runs one
/// after the other.
void sort_runs(std::vector<Key>& keys) {
  std::vector<std::vector<Key>::iterator> bounds{keys.begin()};
  while (bounds.back() != keys.end()) bounds.push_back(std::is_sorted_until(bounds.back(), keys.end()));
  while (bounds.size() > 2) {
    // Merges neighbouring runs, which removes every second boundary.
    std::size_t kept = 1;
    for (std::size_t i = 2; i < bounds.size(); i += 2) {
      std::inplace_merge(bounds[i - 2], bounds[i - 1], bounds[i]);
      bounds[kept++] = bounds[i];
    }
    if (bounds[kept - 1] != keys.end()) bounds[kept++] = keys.end();
    bounds.resize(kept);
  }
}

/// Sort key of the output: within one source the offset orders like line and column.
auto output_key(Reported const& finding) {
  return std::make_tuple(finding.place.source, finding.place.span.begin, finding.rule->code);
}

}  // namespace

void drop_replaced(ReportedFindings const& reported, Standing& standing) {
  std::set<std::pair<Subject, Code>> present;
  for (std::uint32_t const number : standing) {
    Reported const& finding = reported.findings[number];
    if (finding.subject != nullptr) present.emplace(*finding.subject, finding.rule->code);
  }
  if (present.empty()) return;
  std::erase_if(standing, [&](std::uint32_t number) {
    Reported const& finding = reported.findings[number];
    auto const& silenced_by = finding.rule->silenced_by;
    return finding.subject != nullptr && std::any_of(silenced_by.begin(), silenced_by.end(), [&](Code code) {
             return present.contains({*finding.subject, code});
           });
  });
}

void put_in_order(ReportedFindings const& reported, Standing& standing) {
  std::vector<Key> keys;
  keys.reserve(standing.size());
  for (std::uint32_t const number : standing) keys.emplace_back(reported.findings[number], number);
  sort_runs(keys);
  std::transform(keys.begin(), keys.end(), standing.begin(), [](Key const& key) { return key.number; });
}

void merge_shared(ReportedFindings& reported, Standing& standing) {
  Reported* first = nullptr;
  std::erase_if(standing, [&](std::uint32_t number) {
    Reported& finding = reported.findings[number];
    bool const is_same = first != nullptr && finding.place == first->place && finding.rule == first->rule;
    if (!is_same) {
      first = &finding;
      return false;
    }
    // The merged finding belongs to the list, not to one of its axes.
    if (first->axis != finding.axis) first->axis = {};
    return true;
  });
}

void keep_highest_per_token(ReportedFindings const& reported, Standing& standing) {
  Standing chosen;
  chosen.reserve(standing.size());
  std::uint32_t token_end = 0;
  for (std::uint32_t const number : standing) {
    Reported const& finding = reported.findings[number];
    Place const& place = finding.place;
    Place const* const last = chosen.empty() ? nullptr : &reported.findings[chosen.back()].place;
    bool const overlaps = last != nullptr && place.source == last->source &&
                          (place.span.begin < token_end || place.span == last->span);
    token_end = overlaps ? std::max(token_end, place.span.end) : place.span.end;
    if (!overlaps) {
      chosen.push_back(number);
    } else if (order(finding) < order(reported.findings[chosen.back()])) {
      chosen.back() = number;
    }
  }
  standing = std::move(chosen);
}

void put_in_output_order(ReportedFindings const& reported, Standing& standing) {
  auto const comes_before = [&](std::uint32_t left, std::uint32_t right) {
    return output_key(reported.findings[left]) < output_key(reported.findings[right]);
  };
  if (std::is_sorted(standing.begin(), standing.end(), comes_before)) return;
  std::stable_sort(standing.begin(), standing.end(), comes_before);
}

}  // namespace axisc::validator
