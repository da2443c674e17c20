#include "analysis/motion/block_profile.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

constexpr int most_steps = 200;
constexpr double same_velocity = 1e-15;

double way_through(BlockTask const& task, double v) {
  double const in = task.velocity_in;
  return (v >= in ? task.up->way(in, v) : task.down->way(v, in)) + task.down->way(task.velocity_out, v);
}

/// Between a velocity that fits and one that does not. Newton's method, or halving where it leaves them.
double highest_fitting(BlockTask const& task, double low, double high) {
  double v = high;
  double over = way_through(task, high) - task.length;
  bool const rises = low >= task.velocity_in;
  for (int i = 0; i < most_steps && high - low > same_velocity * high; ++i) {
    double next = (low + high) / 2;
    if (rises) {
      double const growth = task.up->growth(task.velocity_in, v) + task.down->growth(task.velocity_out, v);
      double const newton = v - over / growth;
      if (newton > low && newton < high) next = newton;
      // From the fast side the last step may stay there for ever.
      if (std::abs(next - v) <= same_velocity * v) next = v - 2 * same_velocity * v;
      if (!(next > low)) break;
    }
    v = next;
    over = way_through(task, v) - task.length;
    (over <= 0 ? low : high) = v;
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

void append_profile(BlockTask const& task, double v, std::vector<Phase>& phases) {
  auto const first = phases.size();
  if (v >= task.velocity_in) {
    task.up->append_up(task.velocity_in, v, phases);
  } else {
    task.down->append_down(task.velocity_in, v, phases);
  }
  double rest = task.length;
  for (auto i = first; i < phases.size(); ++i) rest -= phases[i].length;
  auto const middle = phases.size();
  task.down->append_down(v, task.velocity_out, phases);
  for (auto i = middle; i < phases.size(); ++i) rest -= phases[i].length;
  // What rounding leaves over at velocity 0 is no way.
  if (!(rest > 0) || !(v > 0)) return;
  phases.insert(phases.begin() + static_cast<std::ptrdiff_t>(middle), Phase::steady(v, rest));
}

}  // namespace axisc::motion
