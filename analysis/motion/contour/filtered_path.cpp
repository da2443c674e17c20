#include "analysis/motion/contour/filtered_path.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace axisc::motion {
namespace {

/// Position units: sums of the steps of a path of hundreds of metres.
constexpr double rounding_of_ways = 1e-3;

double distance(Point const& a, Point const& b, std::size_t axes) {
  double squared = 0;
  for (std::size_t i = 0; i < axes; ++i) squared += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squared);
}

}  // namespace

void FilteredPath::begin(std::size_t points, std::uint64_t cycle) {
  passed_.assign(std::bit_ceil(std::max<std::size_t>(points, 2)), {});
  mask_ = passed_.size() - 1;
  first_ = cycle;
  end_ = cycle;
}

void FilteredPath::append(Point const& point) {
  double way = 0;
  if (end_ != first_) {
    Passed const& before = passed(end_ - 1);
    way = before.way + distance(point, before.point, axes_);
  }
  passed_[end_ & mask_] = {.point = point, .way = way};
  ++end_;
}

/// Halves a stretch of the path until nothing in it can be nearer. A way of length s from an end at distance
/// d to an end at distance e passes within r of the point only if s ≥ (d - r) + (e - r): it comes no nearer
/// than (d + e - s) / 2.
struct FilteredPath::Search {
  FilteredPath const& path;
  Point const& point;
  NearestPoint found{};
  std::uint64_t found_behind = 0;
  double within = 0;  ///< distance of what was found, with room for rounding

  [[nodiscard]] double away(std::uint64_t cycle) const {
    return distance(path.passed(cycle).point, point, path.axes_);
  }
  void look_at(std::uint64_t a, std::uint64_t b) {
    double const before = found.squared;
    found.consider(point, path.passed(a).point, path.passed(b).point, path.axes_);
    if (found.squared >= before) return;
    found_behind = a;
    within = found.distance() + rounding_of_ways;
  }
  /// From cycle `a`, `d` away, to the later cycle `b`, `e` away.
  void look_between(std::uint64_t a, double d, std::uint64_t b, double e) {
    if (d + e - (path.passed(b).way - path.passed(a).way) > 2 * within) return;
    if (b - a == 1) return look_at(a, b);
    auto const middle = a + (b - a) / 2;
    double const m = away(middle);
    look_between(a, d, middle, m);
    look_between(middle, m, b, e);
  }
  /// Stretches that grow with their distance from `begin`, as long as there may be a nearer point up to
  /// `end`.
  void look_towards(std::uint64_t begin, std::uint64_t end) {
    double d = away(begin);
    double const e = away(end);
    for (std::uint64_t stretch = 1; begin != end; stretch *= 2) {
      if (d + e - std::abs(path.passed(end).way - path.passed(begin).way) > 2 * within) return;
      auto const next =
          begin < end ? std::min(end, begin + stretch) : std::max(end + stretch, begin) - stretch;
      double const n = away(next);
      if (begin < end) {
        look_between(begin, d, next, n);
      } else {
        look_between(next, n, begin, d);
      }
      begin = next;
      d = n;
    }
  }
};

FilteredPath::Nearest FilteredPath::nearest(Point const& point, std::uint64_t first, std::uint64_t likely,
                                            std::uint64_t last) const {
  Search search{.path = *this, .point = point};
  likely = std::clamp(likely, first, last);
  auto const behind = std::min(likely + 1, last);
  search.look_at(likely, behind);
  search.look_towards(behind, last);
  search.look_towards(likely, first);
  return {.point = search.found, .cycle = search.found_behind};
}

}  // namespace axisc::motion
