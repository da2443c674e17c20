#include "analysis/motion/planning/block_profile.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

constexpr int most_peak_steps = 200;
constexpr double same_peak = 1e-15;
constexpr double last_peak_step = 1e-8;

double way_through(BlockTask const& task, double v) {
  double const in = task.velocity_in;
  return (v >= in ? task.up->way(in, v) : task.down->way(v, in)) + task.down->way(task.velocity_out, v);
}

/// Between two velocities of which the higher one leads too far: Newton's method, or halving where it leaves
/// them. A step that is this share of the change leaves its square as error.
double highest_fitting(BlockTask const& task, double low, double high) {
  double const slowest = low;
  bool const rises = low >= task.velocity_in;
  double v = high;
  for (int i = 0; i < most_peak_steps && high - low > same_peak * high; ++i) {
    double next = 0;
    if (rises) {
      auto const up = task.up->reach(task.velocity_in, v);
      auto const down = task.down->reach(task.velocity_out, v);
      double const over = up.way + down.way - task.length;
      (over <= 0 ? low : high) = v;
      next = v - over / (up.growth + down.growth);
      if (std::abs(next - v) <= last_peak_step * (v - slowest)) return std::clamp(next, low, high);
    } else {
      (way_through(task, v) <= task.length ? low : high) = v;
    }
    v = next > low && next < high ? next : (low + high) / 2;
  }
  return low;
}

}  // namespace

double middle_velocity(BlockTask const& task) {
  double const slower = std::min(task.velocity_in, task.velocity_out);
  double const faster = std::max(task.velocity_in, task.velocity_out);
  if (task.velocity_in > task.limit) {
    if (way_through(task, task.limit) <= task.length) return task.limit;
    return highest_fitting(task, task.velocity_out, task.limit);
  }
  double const limit = std::max(task.limit, slower);
  if (limit <= faster) return faster;
  if (way_through(task, limit) <= task.length) return limit;
  return highest_fitting(task, faster, limit);
}

void append_profile(BlockTask const& task, double middle, std::vector<Phase>& phases) {
  auto const first = phases.size();
  if (middle >= task.velocity_in) {
    task.up->append_up(task.velocity_in, middle, phases);
  } else {
    task.down->append_down(task.velocity_in, middle, phases);
  }
  double rest = task.length;
  for (auto i = first; i < phases.size(); ++i) rest -= phases[i].length;
  auto const before_braking = phases.size();
  task.down->append_down(middle, task.velocity_out, phases);
  for (auto i = before_braking; i < phases.size(); ++i) rest -= phases[i].length;
  // What rounding leaves over at velocity 0 is no way.
  if (!(rest > 0) || !(middle > 0)) return;
  phases.insert(phases.begin() + static_cast<std::ptrdiff_t>(before_braking), Phase::steady(middle, rest));
}

}  // namespace axisc::motion
