#include "validator/precedence.hpp"

#include <algorithm>
#include <map>
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
  std::map<std::pair<Code, Place>, std::size_t> first_at;
  std::vector<RawFinding> merged;
  merged.reserve(findings.size());
  for (RawFinding& raw : findings) {
    if (raw.finding.place) {
      auto const [first, is_new] =
          first_at.try_emplace({raw.finding.code, *raw.finding.place}, merged.size());
      if (!is_new) {
        // It belongs to the list then, not to one of its axes.
        Finding& kept = merged[first->second].finding;
        if (kept.axis != raw.finding.axis) kept.axis.clear();
        continue;
      }
    }
    merged.push_back(std::move(raw));
  }
  findings = std::move(merged);
}

void keep_highest_per_token(std::vector<RawFinding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](RawFinding const& a, RawFinding const& b) {
    return std::tie(a.finding.place, a.finding.code) < std::tie(b.finding.place, b.finding.code);
  });
  std::vector<RawFinding> kept;
  kept.reserve(findings.size());
  SourceId source{};
  std::uint32_t token_end = 0;
  for (RawFinding& raw : findings) {
    bool overlaps = false;
    if (raw.finding.place) {
      Place const& place = *raw.finding.place;
      bool const had_place = !kept.empty() && kept.back().finding.place.has_value();
      overlaps = had_place && place.source == source &&
                 (place.span.begin < token_end || place.span == kept.back().finding.place->span);
      token_end = overlaps ? std::max(token_end, place.span.end) : place.span.end;
      source = place.source;
    }
    if (!overlaps) {
      kept.push_back(std::move(raw));
    } else if (order(raw.finding) < order(kept.back().finding)) {
      kept.back() = std::move(raw);
    }
  }
  findings = std::move(kept);
}

}  // namespace axisc::validator
