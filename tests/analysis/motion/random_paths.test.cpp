// Random blocks: lines and arcs, all slopes, modes, weights and windows. Nothing exceeds its limit, and the
// motion is continuous.
#include "analysis/motion/program/arc_words.hpp"
#include "motion_oracle.hpp"
#include "planned_path.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <variant>

namespace axisc::motion::random_paths_test {
namespace {

using machine::Slope;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  double logarithmic(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }
  int whole(int low, int high) { return static_cast<int>(std::floor(number(low, high + 1))); }
  bool chance(double share) { return number(0, 1) < share; }

 private:
  std::mt19937_64 engine_;
};

machine::MotionDynamics motion_of(Random& random, double velocity, double most, bool alike) {
  machine::MotionDynamics motion;
  motion.velocity = velocity;
  auto const acceleration = [&] { return most * random.logarithmic(0.1, 1); };
  auto const time = [&] { return random.logarithmic(10'000, 300'000); };
  for (auto* const stages : {&motion.step_up, &motion.step_down}) {
    stages->first = acceleration();
    stages->second = random.chance(0.5) ? stages->first : acceleration();
  }
  motion.step_up.changeover = motion.step_down.changeover = random.logarithmic(5'000, 200'000);
  for (auto* const ramp : {&motion.up, &motion.down}) {
    ramp->acceleration = acceleration();
    ramp->build_up = time();
    ramp->take_back = alike ? ramp->build_up : time();
  }
  return motion;
}

PathDynamics random_dynamics(Random& random) {
  PathDynamics dynamics;
  dynamics.cycle_time = {static_cast<std::uint32_t>(random.whole(1, 4) * 500'000)};
  int const axes = random.whole(2, 4);
  for (int i = 0; i < axes; ++i) {
    bool const alike = random.chance(0.3);
    if (i > 0 && random.chance(0.4)) {
      dynamics.axes.push_back(dynamics.axes.front());
      continue;
    }
    auto& axis = dynamics.axes.emplace_back();
    axis.highest_acceleration = random.logarithmic(500, 30'000);
    double const fastest = random.logarithmic(50'000, 1'000'000);
    axis.feed = motion_of(random, fastest, axis.highest_acceleration, alike);
    axis.rapid = motion_of(random, fastest * random.number(0.3, 1), axis.highest_acceleration, alike);
    axis.curve_ramp_time = random.logarithmic(10'000, 300'000);
    axis.shortest_weighted_ramp_time = random.chance(0.5) ? 10'000 : 0;
    if (random.chance(0.5)) axis.weighted_acceleration = axis.highest_acceleration * random.number(0.5, 2);
    if (random.chance(0.6)) axis.acceleration_transition_weight = random.whole(0, 1000);
    if (random.chance(0.6)) axis.curvature_transition_weight = random.whole(0, 1000);
    axis.corner_jerk = random.chance(0.5) ? random.logarithmic(1, 1000) : 0;
    axis.curvature_jerk = random.chance(0.5) ? random.logarithmic(1, 1000) : 0;
  }
  auto& channel = dynamics.channel;
  channel.slope = static_cast<Slope>(random.whole(0, 3));
  channel.constant_ramp_times = random.chance(0.2);
  channel.limits_curvature_steps = random.chance(0.5);
  channel.transition_mode = static_cast<std::uint8_t>(random.whole(0, 2));
  channel.look_ahead_blocks =
      static_cast<std::uint32_t>(random.chance(0.5) ? random.whole(2, 12) : random.whole(13, 120));
  return dynamics;
}

void set_weights(std::array<AxisWeights, most_axes>& axes, Random& random) {
  for (auto& axis : axes) {
    axis.velocity = random.number(20, 120);
    axis.curve_ramp = random.number(50, 200);
    for (auto* const ramp : {&axis.up, &axis.down}) {
      ramp->acceleration = random.number(20, 200);
      ramp->build_up = random.number(50, 200);
      ramp->take_back = random.number(50, 200);
    }
  }
}

/// A program of random blocks.
class RandomPath {
 public:
  RandomPath(Random& random, PathDynamics const& dynamics)
      : random_(random),
        dynamics_(dynamics),
        size_(random.logarithmic(0.01, 50)),
        changes_words_(random.chance(0.4)) {
    words_.slope = dynamics.channel.slope;
    words_.constant_ramp_times = dynamics.channel.constant_ramp_times;
  }

  ProgrammedBlock next() {
    ProgrammedBlock block;
    if (changes_words_ && random_.chance(0.05)) change_words();
    block.dynamics = said_;
    block.rapid = random_.chance(0.1);
    if (random_.chance(0.2)) feed_ = random_.logarithmic(300, 60'000);
    if (!block.rapid) block.feed = feed_ / 60 * 1e4 * dynamics_.cycle_time.seconds();
    block.exact_stop = random_.chance(0.02);
    block.brakes_late = random_.chance(0.1);
    heading_ += random_.chance(0.5) ? random_.number(-0.02, 0.02) : random_.number(-1.5, 1.5);
    if (random_.chance(0.1)) heading_ += std::numbers::pi;
    if (block.rapid || random_.chance(0.7) || !arc(block)) line(block);
    position_ = block.end;
    return block;
  }

 private:
  void change_words() {
    if (random_.chance(0.5)) words_.slope = static_cast<Slope>(random_.whole(0, 3));
    if (random_.chance(0.5)) set_weights(words_.feed, random_);
    if (random_.chance(0.5)) set_weights(words_.rapid, random_);
    said_ = std::make_shared<BlockDynamics const>(words_);
  }

  void line(ProgrammedBlock& block) {
    double const length = size_ * random_.logarithmic(0.05, 5) * 1e4;
    block.end = position_;
    block.end[0] += std::round(length * std::cos(heading_));
    block.end[1] += std::round(length * std::sin(heading_));
    for (std::size_t i = 2; i < dynamics_.axes.size(); ++i) {
      if (random_.chance(0.3)) block.end[i] += std::round(length * random_.number(-1, 1));
    }
    if (block.end == position_) block.end[0] += 1;
  }

  /// Tangential where the heading did not change.
  bool arc(ProgrammedBlock& block) {
    double const radius = size_ * random_.logarithmic(0.2, 5) * 1e4;
    double const sweep = random_.number(0.1, 6) * (random_.chance(0.5) ? 1 : -1);
    double const side = sweep > 0 ? 1 : -1;
    ArcWords words;
    words.clockwise = sweep < 0;
    words.to_center_first = -side * radius * std::sin(heading_);
    words.to_center_second = side * radius * std::cos(heading_);
    double const x = position_[0] + *words.to_center_first;
    double const y = position_[1] + *words.to_center_second;
    double const angle = std::atan2(position_[1] - y, position_[0] - x) + sweep;
    block.end = position_;
    block.end[0] = x + radius * std::cos(angle);
    block.end[1] = y + radius * std::sin(angle);
    if (dynamics_.axes.size() > 2 && random_.chance(0.3)) block.end[2] += radius * random_.number(-1, 1);
    auto found = arc_of(words, position_, block.end);
    if (!std::holds_alternative<Arc>(found)) return false;
    block.arc = std::make_shared<Arc const>(std::get<Arc>(found));
    heading_ += sweep;
    return true;
  }

  Random& random_;
  PathDynamics const& dynamics_;
  double size_;
  bool changes_words_;
  BlockDynamics words_;
  std::shared_ptr<BlockDynamics const> said_;
  Point position_{};
  double heading_ = 0;
  double feed_ = 6000;
};

void check_path(unsigned seed, test::OracleFigures& all) {
  Random random(seed);
  auto const dynamics = random_dynamics(random);
  RandomPath path(random, dynamics);
  test::PlannedPath planned;
  LookAhead planner(PathLimits(dynamics), false, planned);
  planner.begin({}, {}, 1);
  std::vector<ProgrammedBlock> asked;
  int const blocks = random.whole(5, 400);
  for (int i = 0; i < blocks; ++i) {
    asked.push_back(path.next());
    planner.add(asked.back());
  }
  planner.stop();
  test::OracleFigures figures;
  test::look_at(planned, asked, dynamics, figures);
  INFO("seed " << seed << ", slope " << static_cast<int>(dynamics.channel.slope) << ", window "
               << dynamics.channel.look_ahead_blocks << ", " << blocks << " blocks");
  CHECK(figures.velocity <= 1 + 1e-9);
  CHECK(figures.acceleration <= 1 + 1e-9);
  CHECK(figures.jerk <= 1 + 1e-9);
  CHECK(figures.curve <= 1 + 1e-9);
  CHECK(figures.curve_jerk <= 1 + 1e-9);
  CHECK(figures.corner <= 1 + 1e-9);
  CHECK(figures.curvature_step <= 1 + 1e-9);
  CHECK(figures.time <= 1 + 1e-9);
  CHECK(figures.stopping <= 1 + 1e-9);
  CHECK(figures.position_step <= 1e-9);
  CHECK(figures.velocity_step <= 1e-9);
  CHECK(figures.acceleration_step <= 1e-9);
  all.blocks += figures.blocks;
}

/// A long run says in the environment how many blocks it looks at.
std::size_t wanted_blocks() {
  char const* const text = std::getenv("AXISC_RANDOM_BLOCKS");
  return text != nullptr ? std::strtoul(text, nullptr, 10) : 100'000;
}

}  // namespace

TEST_CASE("random paths keep every limit") {
  test::OracleFigures all;
  for (unsigned seed = 1; all.blocks < wanted_blocks(); ++seed) check_path(seed, all);
}

}  // namespace axisc::motion::random_paths_test
