#include "diagnostics/writers.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace axisc {
namespace {

bool comes_before(Finding const& left, Finding const& right) {
  if (left.place.has_value() != right.place.has_value()) return !left.place.has_value();
  if (!left.place) return std::tie(left.file, left.code) < std::tie(right.file, right.code);
  // Within one source the offset orders like line and column.
  return std::tuple(left.place->source, left.place->span.begin, left.code) <
         std::tuple(right.place->source, right.place->span.begin, right.code);
}

}  // namespace

void sort_findings(std::vector<Finding>& findings) {
  if (std::is_sorted(findings.begin(), findings.end(), comes_before)) return;
  // A finding is large to move: its number is sorted instead.
  std::vector<std::size_t> order(findings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&findings](std::size_t left, std::size_t right) {
    return comes_before(findings[left], findings[right]);
  });
  std::vector<Finding> sorted;
  sorted.reserve(findings.size());
  for (std::size_t const number : order) sorted.push_back(std::move(findings[number]));
  findings = std::move(sorted);
}

}  // namespace axisc
