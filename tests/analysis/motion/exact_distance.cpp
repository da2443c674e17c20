#include "exact_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::test {
namespace {

double distance(Place const& a, Place const& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double dot(Place const& a, Place const& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Place minus(Place const& a, Place const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double phase_of(Leg const& leg) {
  return std::atan2(leg.from[leg.second] - leg.center_second, leg.from[leg.first] - leg.center_first);
}

/// Share of the leg at which a point lies that is not before `from`.
double share_of(Leg const& leg, Place const& point, double from) {
  if (!leg.is_arc) {
    Place const way = minus(leg.to, leg.from);
    return std::clamp(dot(minus(point, leg.from), way) / dot(way, way), 0.0, 1.0);
  }
  double const turned =
      std::atan2(point[leg.second] - leg.center_second, point[leg.first] - leg.center_first) - phase_of(leg);
  double const turn = 2 * std::numbers::pi / std::abs(leg.sweep);
  double share = turned / leg.sweep;
  share -= std::floor(share / turn) * turn;
  // What lies at the beginning of a full circle lies at its end, too.
  if (share > turn - 1e-6) share -= turn;
  while (share < from - 1e-7) share += turn;
  return std::clamp(share, 0.0, 1.0);
}

struct OnContour {
  std::size_t leg = 0;
  double share = 0;
};

/// Of the legs from `at` on the first one on which the setpoint lies; otherwise the nearest of the next.
OnContour place_of(std::vector<Leg> const& contour, Place const& setpoint, OnContour at, double& off) {
  constexpr std::size_t most_ahead = 64;
  double nearest = std::numeric_limits<double>::infinity();
  OnContour found = at;
  for (std::size_t leg = at.leg; leg < std::min(contour.size(), at.leg + most_ahead); ++leg) {
    double const from = leg == at.leg ? at.share : 0;
    double const share = share_of(contour[leg], setpoint, from);
    double const away = distance(contour[leg].at(share), setpoint);
    if (share >= from - 1e-7 && away < nearest) {
      nearest = away;
      found = {.leg = leg, .share = share};
    }
    if (nearest < 1e-4) break;
  }
  off = std::max(off, nearest);
  return found;
}

/// The filtered path in boxes of so many cycles, so that far ones need not be looked at.
class SearchedPath {
 public:
  explicit SearchedPath(std::vector<Place> const& points) : points_(points) {
    for (std::size_t i = 0; i + 1 < points.size(); i += box_size) {
      Box box{.low = points[i], .high = points[i]};
      for (std::size_t k = i; k <= std::min(i + box_size, points.size() - 1); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], points[k][axis]);
          box.high[axis] = std::max(box.high[axis], points[k][axis]);
        }
      }
      boxes_.push_back(box);
    }
  }

  /// Largest component of the vector to the nearest point between two cycles.
  [[nodiscard]] double component(Place const& point, std::size_t from, std::size_t to) {
    to = std::min(to, points_.size() - 1);
    Nearest nearest;
    // Likely where the last point was found; most of the others are then seen to be further away.
    look(point, likely_, from, to, nearest);
    for (std::size_t box = from / box_size; box * box_size < to; ++box) look(point, box, from, to, nearest);
    return nearest.component;
  }

 private:
  struct Box {
    Place low{}, high{};
    [[nodiscard]] double squared_distance(Place const& point) const {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double const beside = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
        sum += beside * beside;
      }
      return sum;
    }
  };
  struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    double component = 0;
  };

  void look(Place const& point, std::size_t box, std::size_t from, std::size_t to, Nearest& nearest) {
    if (boxes_[box].squared_distance(point) >= nearest.squared) return;
    for (std::size_t i = std::max(from, box * box_size); i < std::min(to, (box + 1) * box_size); ++i) {
      Place const way = minus(points_[i + 1], points_[i]);
      double const length = dot(way, way);
      double const along = length > 0 ? std::clamp(dot(minus(point, points_[i]), way) / length, 0.0, 1.0) : 0;
      Place away{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        away[axis] = points_[i][axis] + along * way[axis] - point[axis];
      }
      double const here = dot(away, away);
      if (here >= nearest.squared) continue;
      likely_ = box;
      nearest = {.squared = here,
                 .component = std::max({std::abs(away[0]), std::abs(away[1]), std::abs(away[2])})};
    }
  }

  static constexpr std::size_t box_size = 16;
  std::vector<Place> const& points_;
  std::vector<Box> boxes_;
  std::size_t likely_ = 0;
};

}  // namespace

Place Leg::at(double share) const {
  Place point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = from[i] + share * (to[i] - from[i]);
  if (!is_arc) return point;
  double const radius = std::hypot(from[first] - center_first, from[second] - center_second);
  double const angle = phase_of(*this) + share * sweep;
  point[first] = center_first + radius * std::cos(angle);
  point[second] = center_second + radius * std::sin(angle);
  return point;
}

Followed follow(std::vector<Leg> const& contour, std::vector<Place> const& setpoints,
                std::vector<Place> const& filtered, Neighbourhood neighbourhood, int points_between) {
  std::vector<Place> path(1, contour.front().from);
  path.insert(path.end(), filtered.begin(), filtered.end());
  SearchedPath searched(path);
  Followed found;
  auto const look = [&](std::size_t leg, double share, std::size_t cycle) {
    int const before = static_cast<int>(cycle);
    auto const from = static_cast<std::size_t>(std::max(0, before + neighbourhood.first));
    auto const to = static_cast<std::size_t>(std::max(1, before + 1 + neighbourhood.last));
    double const error = searched.component(contour[leg].at(share), std::min(from, path.size() - 2), to);
    if (error <= found.axis_error) return;
    found.axis_error = error;
    found.leg = leg;
    found.share = share;
  };
  OnContour at;
  look(0, 0, 0);
  for (std::size_t n = 0; n < setpoints.size(); ++n) {
    OnContour const next = place_of(contour, setpoints[n], at, found.off);
    for (std::size_t leg = at.leg; leg <= next.leg; ++leg) {
      double const from = leg == at.leg ? at.share : 0;
      double const to = leg == next.leg ? next.share : 1;
      if (from == to && leg == at.leg && at.leg == next.leg) continue;
      for (int i = 0; i <= points_between + 1; ++i) {
        look(leg, from + (to - from) * i / (points_between + 1), n);
      }
    }
    at = next;
  }
  return found;
}

}  // namespace axisc::test
