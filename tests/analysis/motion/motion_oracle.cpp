#include "motion_oracle.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::test {
namespace {

using machine::AxisDynamics;
using machine::Slope;
using motion::Point;
using std::numbers::pi;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rests = 1e-13;

/// In mm, s.
struct Axis {
  double velocity = 0;
  std::array<double, 2> first{}, second{}, changeover{};          // up, down
  std::array<double, 2> acceleration{}, build_up{}, take_back{};  // up, down
  double curve_time = 0, corner = 0, curvature = 0;

  [[nodiscard]] double step(std::size_t sense, double v) const {
    return v > changeover[sense] ? second[sense] : first[sense];
  }
};

Axis axis_of(AxisDynamics const& list, motion::AxisWeights const& weights, bool rapid, Slope slope,
             motion::PathDynamics const& dynamics) {
  auto const& from = rapid ? list.rapid : list.feed;
  Axis axis;
  axis.velocity =
      std::min(from.velocity * weights.velocity / 100, std::max(from.velocity, list.feed.velocity)) / 1000;
  std::array<machine::AccelerationStages const*, 2> const stages = {&from.step_up, &from.step_down};
  std::array<machine::AccelerationRamp const*, 2> const ramps = {&from.up, &from.down};
  std::array<motion::RampWeights const*, 2> const weight = {&weights.up, &weights.down};
  double const cap = list.weighted_acceleration ? *list.weighted_acceleration : list.highest_acceleration;
  double longest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    auto const weighted = [&](double a) {
      double const wanted = a * weight[i]->acceleration / 100;
      return wanted > a ? std::min(wanted, std::max(a, cap)) : wanted;
    };
    auto const time = [&](double tr, double w) {
      double const wanted = tr * w / 100;
      return (wanted < tr ? std::max(wanted, std::min(tr, list.shortest_weighted_ramp_time)) : wanted) / 1e6;
    };
    axis.first[i] = weighted(stages[i]->first);
    axis.second[i] = weighted(stages[i]->second);
    axis.changeover[i] = stages[i]->changeover / 1000;
    axis.acceleration[i] = weighted(ramps[i]->acceleration);
    axis.build_up[i] = time(ramps[i]->build_up, weight[i]->build_up);
    axis.take_back[i] = time(ramps[i]->take_back, weight[i]->take_back);
    longest = std::max({longest, axis.build_up[i], axis.take_back[i]});
  }
  double const curve = list.curve_ramp_time * weights.curve_ramp / 100;
  axis.curve_time = (weights.curve_ramp < 100
                         ? std::max(curve, std::min(list.curve_ramp_time, list.shortest_weighted_ramp_time))
                         : curve) /
                    1e6;
  if (slope == Slope::hsc) {
    axis.build_up = axis.take_back = {longest, longest};
  }
  double const a = std::min(axis.acceleration[0], axis.acceleration[1]);
  double const T = dynamics.cycle_time.seconds();
  double w = list.acceleration_transition_weight / 1000;
  double w_curve = list.curvature_transition_weight / 1000;
  if (dynamics.channel.transition_mode == 2) {
    w = std::min(1.0, list.corner_jerk * 1000 * T / a);
    w_curve = std::min(1.0, list.curvature_jerk * 1000 * T / a);
  }
  if (w == 0) w = T / longest;
  if (w_curve == 0) w_curve = T / longest;
  if (dynamics.channel.transition_mode == 0) w_curve = std::max(w, w_curve);
  axis.corner = w * a * T;
  axis.curvature = w_curve * a;
  return axis;
}

struct Block {
  motion::ProgrammedBlock const* asked = nullptr;
  PlannedBlock const* planned = nullptr;
  Slope slope = Slope::step;
  std::vector<Axis> axes;
  Point in{}, out{};              ///< directions
  Point curve_in{}, curve_out{};  ///< 1/mm
  double length = 0, feed = 0;    ///< mm, mm/s
  motion::Arc const* arc = nullptr;
};

Point direction(motion::Arc const& arc, double share_of_sweep, Point other) {
  double const angle = arc.phase + arc.sweep * share_of_sweep;
  double const sign = arc.sweep < 0 ? -1 : 1;
  other[arc.first] = -sign * std::sin(angle) * arc.share;
  other[arc.second] = sign * std::cos(angle) * arc.share;
  return other;
}

Point curvature(motion::Arc const& arc, double share_of_sweep) {
  double const angle = arc.phase + arc.sweep * share_of_sweep;
  double const per_mm = 1e4 * arc.share * arc.share / arc.radius;
  Point bend{};
  bend[arc.first] = -std::cos(angle) * per_mm;
  bend[arc.second] = -std::sin(angle) * per_mm;
  return bend;
}

Block block_of(motion::ProgrammedBlock const& asked, PlannedBlock const& planned, Point const& from,
               motion::PathDynamics const& dynamics) {
  Block block;
  block.asked = &asked;
  block.planned = &planned;
  block.arc = asked.arc.get();
  static motion::BlockDynamics const nothing;
  auto const& words = asked.dynamics ? *asked.dynamics : nothing;
  block.slope = asked.dynamics ? words.slope : dynamics.channel.slope;
  for (std::size_t i = 0; i < dynamics.axes.size(); ++i) {
    block.axes.push_back(axis_of(dynamics.axes[i], (asked.rapid ? words.rapid : words.feed)[i], asked.rapid,
                                 block.slope, dynamics));
  }
  double squares = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    squares += (asked.end[i] - from[i]) * (asked.end[i] - from[i]);
  }
  double const units = asked.arc ? asked.arc->length : std::sqrt(squares);
  block.length = units / 1e4;
  block.feed = asked.feed / 1e4 / dynamics.cycle_time.seconds();
  for (std::size_t i = 0; i < from.size(); ++i) block.in[i] = (asked.end[i] - from[i]) / units;
  block.out = block.in;
  if (asked.arc) {
    block.in[asked.arc->first] = block.in[asked.arc->second] = 0;
    block.out = direction(*asked.arc, 1, block.in);
    block.in = direction(*asked.arc, 0, block.in);
    block.curve_in = curvature(*asked.arc, 0);
    block.curve_out = curvature(*asked.arc, 1);
  }
  return block;
}

/// Of a phase, from its numbers alone; cycles and units.
struct Moment {
  double v = 0, a = 0, j = 0, s = 0;
};

Moment moment(motion::Phase const& phase, double t) {
  if (phase.shape == motion::PhaseShape::constant_jerk) {
    return {.v = phase.velocity + phase.acceleration * t + phase.jerk * t * t / 2,
            .a = phase.acceleration + phase.jerk * t,
            .j = phase.jerk,
            .s = phase.velocity * t + phase.acceleration * t * t / 2 + phase.jerk * t * t * t / 6};
  }
  // p sin² = p (1 - cos 2x) / 2, and for a fall the same with a plus sign.
  double const sign = phase.shape == motion::PhaseShape::sine_rise ? -1 : 1;
  double const w = pi / phase.sine_time;
  double const x0 = w * phase.sine_begun;
  double const x = x0 + w * t;
  double const p = phase.acceleration;
  return {.v = phase.velocity + p / 2 * (t + sign * (std::sin(x) - std::sin(x0)) / w),
          .a = p / 2 * (1 + sign * std::cos(x)),
          .j = -sign * p / 2 * w * std::sin(x),
          .s = phase.velocity * t +
               p / 2 * (t * t / 2 - sign * ((std::cos(x) - std::cos(x0)) / w + std::sin(x0) * t) / w)};
}

class Looker {
 public:
  Looker(motion::PathDynamics const& dynamics, OracleFigures& figures)
      : dynamics_(dynamics), T_(dynamics.cycle_time.seconds()), found_(figures) {}

  void look(std::vector<Block> const& blocks) {
    // HSC has a window of its own.
    has_hsc_ = std::any_of(blocks.begin(), blocks.end(),
                           [](Block const& block) { return block.slope == Slope::hsc; });
    Block const* before = nullptr;
    double velocity = 0;
    double acceleration = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      auto const& block = blocks[i];
      begins_late_ = before != nullptr && before->asked->brakes_late;
      if (before == nullptr) {
        raise(found_.velocity_step, std::abs(first(block).v));
      } else {
        junction(*before, block, velocity);
      }
      known(blocks, i, velocity);
      phases(block, before != nullptr, velocity, acceleration);
      bound(block, before == nullptr ? 0 : entry_, velocity);
      bool const stops = block.planned->stops;
      if (stops) raise(found_.velocity_step, std::abs(velocity));
      before = stops ? nullptr : &block;
      // Where the slope changes, the acceleration is 0 or jumps.
      bool const goes_on = i + 1 < blocks.size() && blocks[i + 1].slope == block.slope;
      if (!goes_on && block.slope == Slope::hsc) acceleration_step(acceleration, block);
      if (!goes_on) acceleration = 0;
      if (stops) velocity = acceleration = 0;
      ++found_.blocks;
    }
  }

 private:
  static void raise(double& figure, double by) { figure = std::max(figure, by); }
  [[nodiscard]] double mm_s(double v) const { return v / 1e4 / T_; }
  [[nodiscard]] double mm_s2(double a) const { return a / 1e4 / T_ / T_; }
  [[nodiscard]] double mm_s3(double j) const { return j / 1e4 / T_ / T_ / T_; }
  static Moment first(Block const& block) { return moment(block.planned->phases.front(), 0); }

  void phases(Block const& block, bool moves, double& velocity, double& acceleration) {
    entry_ = moves ? velocity : 0;
    double way = 0;
    bool const across = block.slope == Slope::hsc;
    bool begins = true;
    for (auto const& phase : block.planned->phases) {
      auto const begin = moment(phase, 0);
      auto const end = moment(phase, phase.duration);
      raise(found_.velocity_step, std::abs(begin.v - velocity) / std::max(1.0, velocity));
      if (block.slope != Slope::step) {
        double const expected = begins && !across ? 0 : acceleration;
        if (!begins || !across || moves) acceleration_step(begin.a - expected, block);
      }
      raise(found_.position_step, std::abs(end.s - phase.length) / std::max(1.0, phase.length));
      // Which ramp it is shows in the middle.
      auto const middle = moment(phase, phase.duration / 2);
      sense_ = middle.a > 0 ? 0 : 1;
      builds_ = middle.a * middle.j > 0;
      constexpr int parts = 4;
      for (int n = 0; n <= parts; ++n) limits(block, moment(phase, phase.duration * n / parts));
      way += phase.length;
      velocity = end.v;
      acceleration = end.a;
      begins = false;
    }
    if (block.slope == Slope::trapez || block.slope == Slope::sin2) acceleration_step(acceleration, block);
    raise(found_.position_step, std::abs(way / 1e4 - block.length) / std::max(1.0, block.length));
    // Braking for the feed of a block may begin with it, and is over at its end.
    raise(found_.velocity, mm_s(velocity) / block.feed);
  }

  void acceleration_step(double step, Block const& block) {
    double most = 0;
    for (auto const& axis : block.axes) most = std::max({most, axis.acceleration[0], axis.acceleration[1]});
    raise(found_.acceleration_step, std::abs(mm_s2(step)) / most);
  }

  void limits(Block const& block, Moment const& at) {
    double const v = mm_s(at.v);
    double const a = mm_s2(at.a);
    double const j = mm_s3(at.j);
    if (!begins_late_) raise(found_.velocity, v / block.feed);
    Point along = block.in;
    if (block.arc != nullptr) {
      along[block.arc->first] = along[block.arc->second] = 0;
      arc(block, v, a, j);
    }
    for (std::size_t i = 0; i < block.axes.size(); ++i) {
      double const share = std::abs(along[i]);
      if (share < rests) continue;
      auto const& axis = block.axes[i];
      raise(found_.velocity, share * v / axis.velocity);
      if (block.slope == Slope::step) {
        // At a changeover either stage may count.
        double const allowed =
            std::max(axis.step(sense_, share * v * (1 - 1e-9)), axis.step(sense_, share * v * (1 + 1e-9)));
        raise(found_.acceleration, share * std::abs(a) / allowed);
        continue;
      }
      raise(found_.acceleration, share * std::abs(a) / axis.acceleration[sense_]);
      raise(found_.jerk, share * std::abs(j) / jerk_limit(block, axis));
    }
  }

  [[nodiscard]] double jerk_limit(Block const& block, Axis const& axis) const {
    double const time = builds_ ? axis.build_up[sense_] : axis.take_back[sense_];
    double const shape = block.slope == Slope::sin2 ? pi / 2 : 1;
    return shape * axis.acceleration[sense_] / time;
  }

  void arc(Block const& block, double v, double a, double j) {
    auto const& arc = *block.arc;
    double const radius = arc.radius / 1e4 / (arc.share * arc.share);
    double weak = infinite;
    double turn_jerk = infinite;
    double along_jerk = infinite;
    for (auto const i : {arc.first, arc.second}) {
      auto const& axis = block.axes[i];
      raise(found_.velocity, v * arc.share / axis.velocity);
      for (std::size_t s = 0; s < 2; ++s) {
        weak = std::min(weak, block.slope == Slope::step ? std::min(axis.first[s], axis.second[s])
                                                         : axis.acceleration[s]);
      }
      turn_jerk = std::min(turn_jerk, std::min(axis.acceleration[0], axis.acceleration[1]) / axis.curve_time);
      if (block.slope != Slope::step) along_jerk = std::min(along_jerk, jerk_limit(block, axis));
    }
    double const across = v * v / radius;
    raise(found_.curve, across * std::numbers::sqrt2 / weak);
    raise(found_.acceleration, std::hypot(a * arc.share, across) / weak);
    if (block.slope == Slope::step) return;
    raise(found_.curve_jerk, v * v * v / (radius * radius) / turn_jerk);
    raise(found_.jerk, std::abs(j) * arc.share / along_jerk);
  }

  void junction(Block const& before, Block const& after, double velocity) {
    double const v = mm_s(velocity);
    for (Block const* const block : {&before, &after}) {
      for (std::size_t i = 0; i < block->axes.size(); ++i) {
        auto const& axis = block->axes[i];
        double const turn = std::abs(after.in[i] - before.out[i]);
        if (turn > 1e-11) {
          double const fast = v * std::max(std::abs(after.in[i]), std::abs(before.out[i]));
          double const step =
              block->slope == Slope::step
                  ? std::min(axis.step(0, fast * (1 - 1e-9)), axis.step(1, fast * (1 - 1e-9))) * T_
                  : axis.corner;
          raise(found_.corner, v * turn / step);
        }
        if (!dynamics_.channel.limits_curvature_steps || block->slope == Slope::step) continue;
        double const bend = std::abs(after.curve_in[i] - before.curve_out[i]);
        raise(found_.curvature_step, v * v * bend / axis.curvature);
      }
    }
  }

  /// The strongest acceleration along a block, whatever bends.
  static double strongest(Block const& block, std::size_t sense) {
    Point along = block.in;
    double least = infinite;
    if (block.arc != nullptr) {
      along[block.arc->first] = along[block.arc->second] = 0;
      for (auto const i : {block.arc->first, block.arc->second}) {
        auto const& axis = block.axes[i];
        double const a = block.slope == Slope::step ? std::max(axis.first[sense], axis.second[sense])
                                                    : axis.acceleration[sense];
        least = std::min(least, a / block.arc->share);
      }
    }
    for (std::size_t i = 0; i < block.axes.size(); ++i) {
      if (std::abs(along[i]) < rests) continue;
      auto const& axis = block.axes[i];
      double const a = block.slope == Slope::step ? std::max(axis.first[sense], axis.second[sense])
                                                  : axis.acceleration[sense];
      least = std::min(least, a / std::abs(along[i]));
    }
    return least;
  }

  /// The path can stop within the blocks that are known.
  void known(std::vector<Block> const& blocks, std::size_t first, double velocity) {
    if (has_hsc_) return;
    double squares = 0;
    std::size_t const end = std::min(blocks.size(), first + std::size_t{dynamics_.channel.look_ahead_blocks});
    for (std::size_t i = first; i < end; ++i) squares += 2 * strongest(blocks[i], 1) * blocks[i].length;
    double const v = mm_s(velocity);
    raise(found_.stopping, v * v / squares);
  }

  /// Constant accelerations between the same velocities, up to the highest one that was driven.
  void bound(Block const& block, double in, double out) {
    double const v0 = mm_s(in);
    double const v1 = mm_s(out);
    double peak = std::max(v0, v1);
    for (auto const& phase : block.planned->phases) peak = std::max(peak, mm_s(phase.velocity));
    double const up = strongest(block, 0);
    double const down = strongest(block, 1);
    double const reached =
        std::sqrt((2 * block.length * up * down + v0 * v0 * down + v1 * v1 * up) / (up + down));
    double const v = std::min(peak, reached);
    if (!(v > 0)) return;
    double const t_up = std::max(0.0, v - v0) / up;
    double const t_down = std::max(0.0, v - v1) / down;
    double const rest = block.length - (v + v0) / 2 * t_up - (v + v1) / 2 * t_down;
    double const shortest = t_up + t_down + std::max(0.0, rest) / v;
    raise(found_.time, shortest / (block.planned->cycles() * T_));
  }

  motion::PathDynamics const& dynamics_;
  double T_;
  OracleFigures& found_;
  double entry_ = 0;
  bool begins_late_ = false;
  bool has_hsc_ = false;
  std::size_t sense_ = 0;  ///< up, down
  bool builds_ = false;    ///< the acceleration
};

}  // namespace

double OracleFigures::largest_share() const {
  return std::max({velocity, acceleration, jerk, curve, curve_jerk, corner, curvature_step, time, stopping});
}

void look_at(PlannedPath const& path, std::vector<motion::ProgrammedBlock> const& asked,
             motion::PathDynamics const& dynamics, OracleFigures& figures) {
  REQUIRE(path.blocks.size() == asked.size());
  std::vector<Block> blocks;
  Point from{};
  for (std::size_t i = 0; i < asked.size(); ++i) {
    blocks.push_back(block_of(asked[i], path.blocks[i], from, dynamics));
    from = asked[i].end;
  }
  Looker(dynamics, figures).look(blocks);
}

}  // namespace axisc::test
