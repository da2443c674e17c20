#include "validator/precedence.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace axisc::validator {
namespace {

int rank(Code code) {
  switch (static_cast<std::uint16_t>(code)) {
    case 2002:
    case 2003:
    case 2004:
    case 2007:
    case 2015:
      return 5;
    case 2006:
    case 2009:
    case 2014:
    case 2016:
      return 1;  // Warnings, which the other codes of AX2 are not: the lower code.
    case 2005:
      return 7;
    case 3009:
    case 3023:
    case 3024:
      return 4;
    default:
      break;
  }
  switch (static_cast<std::uint16_t>(code) / 1000) {
    case 1:
      return 0;
    case 4:
      return 2;
    case 3:
      return 3;
    case 2:
      return 6;
    default:
      return 8;
  }
}

auto order(Finding const& finding) {
  return std::make_tuple(finding.severity, rank(finding.code), finding.code);
}

/// What decides about the order, side by side: the findings themselves lie far apart.
struct Key {
  std::optional<Place> place;
  Code code{};
  std::uint32_t number = 0;
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(Key const&, Key const&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace

void drop_replaced(ReportedFindings const& reported, Standing& standing) {
  std::set<std::pair<Subject, Code>> present;
  for (std::uint32_t const number : standing) {
    auto const& subject = reported.subjects[number];
    if (subject) present.emplace(*subject, reported.findings[number].code);
  }
  std::erase_if(standing, [&](std::uint32_t number) {
    auto const& subject = reported.subjects[number];
    Rule const* const rule = subject ? find_rule(reported.findings[number].code) : nullptr;
    return rule != nullptr && std::any_of(rule->silenced_by.begin(), rule->silenced_by.end(), [&](Code code) {
             return present.contains({*subject, code});
           });
  });
}

void put_in_order(ReportedFindings const& reported, Standing& standing) {
  std::vector<Key> keys;
  keys.reserve(standing.size());
  for (std::uint32_t const number : standing) {
    Finding const& finding = reported.findings[number];
    keys.push_back({.place = finding.place, .code = finding.code, .number = number});
  }
  std::sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), standing.begin(), [](Key const& key) { return key.number; });
}

void merge_shared(ReportedFindings& reported, Standing& standing) {
  Finding* first = nullptr;
  std::erase_if(standing, [&](std::uint32_t number) {
    Finding& finding = reported.findings[number];
    bool const is_same =
        first != nullptr && finding.place && finding.place == first->place && finding.code == first->code;
    if (!is_same) {
      first = &finding;
      return false;
    }
    // It belongs to the list then, not to one of its axes.
    if (first->axis != finding.axis) first->axis.clear();
    return true;
  });
}

void keep_highest_per_token(ReportedFindings const& reported, Standing& standing) {
  Standing chosen;
  chosen.reserve(standing.size());
  SourceId source{};
  std::uint32_t token_end = 0;
  for (std::uint32_t const number : standing) {
    Finding const& finding = reported.findings[number];
    bool overlaps = false;
    if (finding.place) {
      Place const& place = *finding.place;
      auto const* const last = chosen.empty() ? nullptr : &reported.findings[chosen.back()].place;
      bool const had_place = last != nullptr && last->has_value();
      overlaps = had_place && place.source == source &&
                 (place.span.begin < token_end || place.span == (*last)->span);
      token_end = overlaps ? std::max(token_end, place.span.end) : place.span.end;
      source = place.source;
    }
    if (!overlaps) {
      chosen.push_back(number);
    } else if (order(finding) < order(reported.findings[chosen.back()])) {
      chosen.back() = number;
    }
  }
  standing = std::move(chosen);
}

}  // namespace axisc::validator
