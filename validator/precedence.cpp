#include "validator/precedence.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <tuple>

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

/// Their numbers by place and code, else as they came: a finding is large to move.
std::vector<std::uint32_t> in_order(std::vector<RawFinding> const& findings) {
  std::vector<std::uint32_t> numbers(findings.size());
  std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
  std::sort(numbers.begin(), numbers.end(), [&findings](std::uint32_t left, std::uint32_t right) {
    Finding const& a = findings[left].finding;
    Finding const& b = findings[right].finding;
    return std::tie(a.place, a.code, left) < std::tie(b.place, b.code, right);
  });
  return numbers;
}

}  // namespace

void drop_replaced(std::vector<RawFinding>& findings) {
  std::set<std::pair<Subject, Code>> reported;
  for (RawFinding const& raw : findings) {
    if (raw.subject) reported.emplace(*raw.subject, raw.finding.code);
  }
  auto const replaced = [&reported](RawFinding const& raw) {
    Rule const* const rule = find_rule(raw.finding.code);
    if (!raw.subject || rule == nullptr) return false;
    return std::any_of(rule->silenced_by.begin(), rule->silenced_by.end(), [&](Code code) {
      return reported.contains({*raw.subject, code});
    });
  };
  findings.erase(std::remove_if(findings.begin(), findings.end(), replaced), findings.end());
}

void merge_shared(std::vector<RawFinding>& findings) {
  std::vector<bool> merged(findings.size(), false);
  bool any = false;
  Finding* first = nullptr;
  for (std::uint32_t const number : in_order(findings)) {
    Finding& finding = findings[number].finding;
    bool const is_same =
        first != nullptr && finding.place && finding.place == first->place && finding.code == first->code;
    if (!is_same) {
      first = &finding;
      continue;
    }
    // It belongs to the list then, not to one of its axes.
    if (first->axis != finding.axis) first->axis.clear();
    merged[number] = true;
    any = true;
  }
  if (!any) return;
  std::size_t next = 0;
  std::erase_if(findings, [&](RawFinding const&) { return merged[next++]; });
}

void keep_highest_per_token(std::vector<RawFinding>& findings) {
  std::vector<std::uint32_t> chosen;
  chosen.reserve(findings.size());
  SourceId source{};
  std::uint32_t token_end = 0;
  for (std::uint32_t const number : in_order(findings)) {
    Finding const& finding = findings[number].finding;
    bool overlaps = false;
    if (finding.place) {
      Place const& place = *finding.place;
      auto const* const last = chosen.empty() ? nullptr : &findings[chosen.back()].finding.place;
      bool const had_place = last != nullptr && last->has_value();
      overlaps = had_place && place.source == source &&
                 (place.span.begin < token_end || place.span == (*last)->span);
      token_end = overlaps ? std::max(token_end, place.span.end) : place.span.end;
      source = place.source;
    }
    if (!overlaps) {
      chosen.push_back(number);
    } else if (order(finding) < order(findings[chosen.back()].finding)) {
      chosen.back() = number;
    }
  }
  std::vector<RawFinding> kept;
  kept.reserve(chosen.size());
  for (std::uint32_t const number : chosen) kept.push_back(std::move(findings[number]));
  findings = std::move(kept);
}

}  // namespace axisc::validator
