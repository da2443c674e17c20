#include "analysis/motion/contour/corner_passage.hpp"

#include "analysis/motion/contour/nearest_point.hpp"
#include "analysis/motion/contour/plane.hpp"
#include "analysis/motion/planning/junction.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// The plane of a path's first axis and another one; of one axis with itself.
PathDynamics plane_of(PathDynamics dynamics, std::size_t second) {
  dynamics.axes = {dynamics.axes.front(), dynamics.axes[second]};
  return dynamics;
}

/// The cosine of a right angle is 0, whatever is left of π/2.
double exactly_zero(double component) {
  constexpr double rounding = 1e-15;
  return std::abs(component) < rounding ? 0 : component;
}

CornerLeg leg(Point const& direction, double velocity, std::vector<Phase> ramp) {
  CornerLeg leg{.direction = direction, .velocity = velocity, .ramp = std::move(ramp)};
  for (auto const& phase : leg.ramp) {
    leg.ramp_time += phase.duration;
    leg.ramp_way += phase.length;
  }
  return leg;
}

CornerPassage pass_in_plane(PathDynamics const& dynamics, CornerTask const& task) {
  PathLimits limits(dynamics);
  limits.set_acceleration_factor(task.acceleration_factor);
  auto const line = [&](Point const& from, Point const& to) {
    ProgrammedBlock asked;
    asked.end = to;
    asked.feed = task.feed;
    return limits.block(asked, from, 1, asked.feed, false);
  };
  Point const u0{1};
  Point const u1{exactly_zero(std::cos(task.turn)), exactly_zero(std::sin(task.turn))};
  auto const before = line(minus({}, u0), {});
  auto const behind = line({}, u1);
  double const velocity = junction_limit(before, behind).velocity;
  std::vector<Phase> down;
  std::vector<Phase> up;
  before.down.append_down(before.velocity, velocity, down);
  behind.up.append_up(velocity, behind.velocity, up);
  CornerPassage passage{.before = leg(u0, before.velocity, std::move(down)),
                        .behind = leg(u1, behind.velocity, std::move(up)),
                        .velocity = velocity};
  auto const step = step_limit(before, behind);
  if (step.velocity < std::min(before.velocity, behind.velocity)) {
    passage.slowed_by = step.axis;
    passage.step = velocity * std::abs(u1[step.axis] - u0[step.axis]);
  }
  return passage;
}

/// The way passed so long after the ramp began; along at `velocity` behind its end.
double way_at(CornerLeg const& leg, double t, double velocity) {
  double way = 0;
  for (auto const& phase : leg.ramp) {
    if (t <= phase.duration) return way + phase.way_at(t);
    t -= phase.duration;
    way += phase.length;
  }
  return way + velocity * t;
}

/// One component of the setpoints, as the chain answers them:  y[n] = Σ b[k] x[n-k].
std::vector<double> filtered(ChainAnswer const& chain, std::vector<double> const& setpoints,
                             std::size_t first) {
  std::vector<double> taps;
  for (std::size_t k = 0; k < chain.tap_count(); ++k) taps.push_back(chain.tap(k));
  std::vector<double> path;
  for (std::size_t n = first; n < setpoints.size(); ++n) {
    double sum = 0;
    for (std::size_t k = 0; k < taps.size(); ++k) sum += taps[k] * setpoints[n - k];
    path.push_back(sum);
  }
  return path;
}

/// The points of the corner's surroundings are those of the setpoints within reach, the corner among them.
ContourFigures predict_in_plane(Plane const& plane, CornerPassage const& passage) {
  auto const reach = static_cast<int>(std::ceil(plane.reach()));
  auto const latest = static_cast<int>(std::round(plane.latest()));
  std::size_t const taps = std::max(plane.first.tap_count(), plane.second.tap_count());
  int const begin = latest - 2 * reach;
  std::vector<double> x;
  std::vector<double> y;
  for (int n = begin - static_cast<int>(taps); n <= latest + 2 * reach; ++n) {
    auto const setpoint = passage.setpoint_at(n);
    x.push_back(setpoint[0]);
    y.push_back(setpoint[1]);
  }
  auto const x_path = filtered(plane.first, x, taps);
  auto const y_path = filtered(plane.second, y, taps);
  std::vector<Point> path;
  for (std::size_t i = 0; i < x_path.size(); ++i) path.push_back({x_path[i], y_path[i]});
  SearchedPath const searched(std::move(path));
  ContourFigures figures;
  int const first_cycle = -2 * reach;
  for (int n = -reach; n <= reach; ++n) {
    figures.take(searched.nearest(passage.setpoint_at(n), static_cast<std::size_t>(n - first_cycle)));
  }
  return figures;
}

}  // namespace

Point CornerPassage::setpoint_at(double cycles) const {
  if (cycles >= 0) return plus({}, way_at(behind, cycles, behind.velocity), behind.direction);
  double const since_ramp = before.ramp_time + cycles;
  double const left = since_ramp < 0 ? before.ramp_way - before.velocity * since_ramp
                                     : before.ramp_way - way_at(before, since_ramp, velocity);
  return plus({}, -left, before.direction);
}

std::vector<CornerPassage> pass_corner(PathDynamics const& dynamics, CornerTask const& task) {
  std::size_t const axes = dynamics.axes.size();
  std::vector<CornerPassage> planes;
  for (std::size_t i = 0; i < std::max<std::size_t>(axes - 1, 1); ++i) {
    std::size_t const second = std::min(i + 1, axes - 1);
    auto& passage = planes.emplace_back(pass_in_plane(plane_of(dynamics, second), task));
    if (passage.slowed_by && *passage.slowed_by > 0) passage.slowed_by = second;
  }
  return planes;
}

std::optional<ContourFigures> predict_passage(std::span<ChainAnswer const> answers,
                                              std::span<CornerPassage const> planes) {
  bool const is_far = std::any_of(answers.begin(), answers.end(), [](ChainAnswer const& answer) {
    return answer.reach > longest_passage_reach;
  });
  if (is_far) return std::nullopt;
  return over_planes(answers, [planes](Plane const& plane, std::size_t number) {
    return predict_in_plane(plane, planes[number]);
  });
}

}  // namespace axisc::motion
