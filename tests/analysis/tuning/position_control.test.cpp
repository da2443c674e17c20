#include "analysis/motion/point.hpp"
#include "analysis/tuning/position_control/control_lines.hpp"
#include "analysis/tuning/position_control/damping_search.hpp"
#include "analysis/tuning/position_control/loop_answer.hpp"
#include "analysis/tuning/position_control/loop_trials.hpp"
#include "analysis/tuning/position_control/stage_settings.hpp"
#include "analysis/tuning/position_control/whole_loop.hpp"
#include "support/catch.hpp"
#include "support/step_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::tuning::position_control_test {
namespace {

using machine::PositionControl;
using machine::StageMode;

constexpr double pi = std::numbers::pi;
constexpr double um_per_m = 1e6;
constexpr double units_per_m = 1e7;

/// samples/motion/rack: the teeth pass at 53 Hz, the column swings at 11 Hz.
LoopTask rack(std::vector<Resonance> resonances) {
  LoopTask task;
  task.cycle_time = {1'000'000};
  task.axis.name = "X";
  task.axis.velocity_limit = 600'000;
  task.plant = {.motor_mass = 500,
                .load_mass = 1060,
                .stiffness = 117.5e6,
                .damping = 20e3,
                .tooth_pitch = 0.01,
                .transmission_error = 2.8e-6,
                .structure_mass = 1500,
                .structure_frequency = 11.75,
                .structure_damping = 0.015,
                .dead_time = 250e-6,
                .velocity_bandwidth = 57,
                .kv = 60,
                .feedforward = 0.44,
                .feedback = motion::PositionFeedback::motor};
  task.resonances = std::move(resonances);
  task.velocity = 530 * motion::units_per_mm * 1e-3;
  task.dynamics = test::step_dynamics(7650 * motion::units_per_mm * 1e-6);
  task.radius = 100 * motion::units_per_mm;
  task.tolerance = 0.1 * motion::units_per_mm;
  return task;
}

/// The column alone: no teeth, so that the plant is quickly simulated.
LoopTask column() {
  auto task = rack({{.frequency = 11}});
  task.plant.transmission_error = 0;
  return task;
}

/// The whole loop with one plant: swing of the first resonance and largest shift of the load; none where it
/// diverges.
struct Whole {
  double swing = 0, shift = 0;
};
std::optional<Whole> whole(LoopTask const& task, motion::PlantParameters const& plant,
                           PositionControl const& control) {
  auto runtime = loop_runtime(task, control);
  double const T = task.cycle_time.seconds();
  auto const without = motion::simulate_loop(runtime, move_of(task), plant, false);
  auto const with = motion::simulate_loop(runtime, move_of(task), plant, true);
  if (motion::diverges(with, T)) return std::nullopt;
  auto const travel = motion::load_accelerations(with, motion::MovePhase::travel, false);
  auto const rest = motion::load_accelerations(with, motion::MovePhase::rest, false);
  Whole found{.swing = swing({travel, rest}, T, task.resonances.front())};
  for (std::size_t n = 0; n < counted_cycles(with); ++n) {
    found.shift =
        std::max(found.shift, std::abs(with.cycles[n].load_position - without.cycles[n].load_position));
  }
  return found;
}

/// Largest distance of the loads with and without function in the second of two revolutions of a circle,
/// simulated.
double simulated_circle(LoopTask const& task, PositionControl const& control) {
  double const T = task.cycle_time.seconds();
  auto runtime = loop_runtime(task, control);
  static_cast<void>(runtime.reset_all(0));
  auto parameters = task.plant;
  parameters.transmission_error = 0;
  motion::Plant with(parameters, T);
  motion::Plant without(parameters, T);
  double const revolution = 2 * pi * task.radius / task.velocity;
  double before = 0;
  double largest = 0;
  for (int n = 1; n < 3 * revolution; ++n) {
    double const x = task.radius / units_per_m * (1 - std::cos(2 * pi * n / revolution));
    std::vector<double> v_add(1), increments(1);
    for (auto* const plant : {&with, &without}) {
      auto const motion = plant->motion();
      double const v =
          parameters.kv * (x - motion.motor_position) + parameters.feedforward * (x - before) / T;
      v_add = {0};
      if (plant == &with) {
        std::vector<double> const set{v * um_per_m};
        std::vector<double> const motor{motion.motor_velocity * um_per_m};
        std::vector<double> const direct{motion.load_velocity * um_per_m};
        static_cast<void>(
            runtime.step_velocity({.set = set, .motor = motor, .direct = direct}, v_add, increments));
      }
      plant->step(v + v_add[0] / um_per_m);
    }
    before = x;
    if (n < 2 * revolution) continue;
    double const apart = std::abs(with.motion().load_position - without.motion().load_position);
    largest = std::max(largest, apart * units_per_m);
  }
  return largest;
}

PositionControl control_of(machine::PositionControlStage stage, double weight) {
  stage.weight_numerator = weight * stage.weight_denominator;
  return {.stages = {stage}, .limit_factor = 1000};
}

/// Worst swing over the plants, where every one of them stays stable, with twice the weight too.
std::optional<double> robust_swing(LoopTask const& task, PositionControl const& control) {
  double worst = 0;
  for (auto const& plant : plants_of(task)) {
    auto const found = whole(task, plant, control);
    if (!found || !whole(task, plant, with_doubled_weights(control))) return std::nullopt;
    worst = std::max(worst, found->swing);
  }
  return worst;
}

Damping damped(LoopTask const& task) {
  auto found = damp(task);
  REQUIRE(std::holds_alternative<Damping>(found));
  return std::get<Damping>(std::move(found));
}

NoDamping refused(LoopTask const& task) {
  auto found = damp(task);
  REQUIRE(std::holds_alternative<NoDampingFound>(found));
  return std::get<NoDampingFound>(found).reason;
}

}  // namespace

TEST_CASE("what a setting adds to a move is what the whole loop shows") {
  for (auto const& resonance : {Resonance{.frequency = 53}, Resonance{.frequency = 11}}) {
    auto const task = rack({resonance});
    auto const stages = stages_for(resonance.frequency, 0, task.cycle_time);
    std::vector<PositionControl> controls;
    for (std::size_t i = 0; i < stages.size(); i += 29) controls.push_back(control_of(stages[i], 0.31));
    REQUIRE(controls.size() > 10);
    auto const trials = LoopTrials(task, task.plant).with(controls);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      INFO(short_name(controls[i], Language::english));
      auto const expected = whole(task, task.plant, controls[i]);
      if (!expected) CHECK(trials[i].grows);
      if (!expected || trials[i].grows) continue;
      ++compared;
      CHECK(trials[i].swings.front() == Approx(expected->swing).epsilon(0.01));
      CHECK(trials[i].shift == Approx(expected->shift).epsilon(0.02));
    }
    CHECK(compared > controls.size() / 2);
  }
}

TEST_CASE("what a setting moves on a circle is what a simulated circle shows") {
  auto task = rack({{.frequency = 11}});
  task.radius = 200 * motion::units_per_mm;
  LoopAnswer const answer(task.plant, task.cycle_time);
  double const frequency = task.velocity / task.radius / (2 * pi * task.cycle_time.seconds());
  for (auto const& stage : stages_for(11, 0, task.cycle_time)) {
    auto const& filter = stage.filters.front();
    if (filter.order > 1 || filter.quality != 2 || filter.frequency.value != 11) continue;
    auto const control = control_of(stage, 0.4);
    INFO(short_name(control, Language::english));
    auto const expected = simulated_circle(task, control);
    REQUIRE(expected > 1);
    CHECK(task.radius * shift_at(answer.at(frequency), frequency, control, task.cycle_time) ==
          Approx(expected).epsilon(0.02));
  }
}

TEST_CASE("no other setting of the grid does better in the whole loop") {
  for (bool const least_vibration : {false, true}) {
    auto task = column();
    task.least_vibration = least_vibration;
    auto const found = damped(task);
    double unfiltered = 0;
    for (auto const& plant : plants_of(task)) {
      unfiltered = std::max(unfiltered, whole(task, plant, {})->swing);
    }
    auto const& stage = found.control.stages.front();
    auto const swing = robust_swing(task, found.control);
    REQUIRE(swing.has_value());
    CHECK(*swing == Approx(found.resonances.front().worst).epsilon(0.02));
    CHECK(simulated_circle(task, found.control) == Approx(found.circle).epsilon(0.02));
    CHECK(found.circle <= task.tolerance);
    double const share = *swing / unfiltered;
    CHECK(share < 0.51);

    auto const stages = stages_for(11, 0, task.cycle_time);
    std::size_t better = 0;
    for (std::size_t i = 0; i < stages.size() * weight_numerators.size(); i += 11) {
      auto const control = control_of(stages[i / weight_numerators.size()],
                                      weight_numerators[i % weight_numerators.size()] / weight_denominator);
      auto const here = whole(task, task.plant, control);
      // What is not better with the plant itself cannot be better in the worst case.
      bool const is_rival =
          here && (least_vibration ? here->swing < 0.98 * *swing
                                   : here->shift < 0.98 * found.shift && here->swing < 0.49 * unfiltered);
      if (!is_rival || simulated_circle(task, control) > 0.98 * task.tolerance) continue;
      auto const worst = robust_swing(task, control);
      if (!worst || *worst > (least_vibration ? 0.98 * *swing : 0.49 * unfiltered)) continue;
      ++better;
      INFO(short_name(control, Language::english)
           << " instead of " << short_name(found.control, Language::english));
      CHECK(better == 0);
    }
    CHECK(stage.index == 0);
  }
}

TEST_CASE("two resonances get a stage each, and the limit of the additive velocity leaves room") {
  auto const found = damped(rack({{.frequency = 53}, {.frequency = 11}}));
  REQUIRE(found.control.stages.size() == 2);
  CHECK(found.control.stages[1].index == 1);
  for (auto const& resonance : found.resonances) {
    CHECK(resonance.with < 0.75 * resonance.without);
    CHECK(resonance.worst < 0.75 * resonance.worst_without);
  }
  CHECK(are_apart(found.control.stages[0], found.control.stages[1]));
  CHECK(found.control.limit_factor / 1000 * 600'000 >= 2 * found.additive_velocity);
}

TEST_CASE("a resonance that the plant has not gets no stage") {
  CHECK(refused(rack({{.frequency = 25}})) == NoDamping::no_resonance);
  auto const found = damped(rack({{.frequency = 25}, {.frequency = 11}}));
  CHECK(found.control.stages.size() == 1);
  CHECK_FALSE(found.resonances[0].is_in_plant);
  CHECK_FALSE(found.resonances[0].stage.has_value());
  CHECK(found.resonances[1].stage == 0U);
}

TEST_CASE(
    "nothing is suggested for a load that hardly swings, a loop that diverges and a tolerance of nothing") {
  auto slow = rack({{.frequency = 53}});
  slow.velocity /= 10;
  slow.dynamics = test::step_dynamics(765 * motion::units_per_mm * 1e-6);
  CHECK(refused(slow) == NoDamping::still);
  auto harsh = column();
  harsh.plant.feedback = motion::PositionFeedback::direct;
  harsh.plant.kv = 900;
  CHECK(refused(harsh) == NoDamping::diverges);
  auto strict = column();
  strict.tolerance = 0;
  CHECK(refused(strict) == NoDamping::not_enough);
}

TEST_CASE("settings that would have findings are not in the grid") {
  // 45° of two cycles at T = 1 ms: 62.5 Hz; of one cycle: 125 Hz.
  for (auto const& stage : stages_for(60, 0, {1'000'000})) {
    if (stage.mode == StageMode::indirect) CHECK(stage.filters.front().frequency.value <= 62.5);
  }
  auto const high = stages_for(130, 2, {1'000'000});
  CHECK(std::none_of(high.begin(), high.end(),
                     [](auto const& stage) { return stage.mode == StageMode::indirect; }));
  CHECK(std::any_of(high.begin(), high.end(),
                    [](auto const& stage) { return stage.mode == StageMode::set_point; }));
  CHECK(std::all_of(high.begin(), high.end(), [](auto const& stage) { return stage.index == 2; }));
}

TEST_CASE("Improved Position Control is written with all its parameters") {
  machine::PositionControlStage stage{.index = 1,
                                      .mode = StageMode::indirect,
                                      .oscillator = design::OscillatorSpecification{{11.4}, 0.8},
                                      .filters = {{.type = design::FilterType::bandpass,
                                                   .prototype = design::Prototype::butterworth,
                                                   .order = 1,
                                                   .frequency = {11.4},
                                                   .quality = 2}},
                                      .weight_numerator = 1750,
                                      .weight_denominator = 1000};
  PositionControl const control{.stages = {stage}, .limit_factor = 120};
  std::string const prefix = "lr_param.improved_position_control.";
  CHECK(control_lines(control) == std::vector<ListLine>{{prefix + "enable", "1"},
                                                        {prefix + "v_add_max_fact", "120"},
                                                        {prefix + "stage[1].mode", "INDIRECT"},
                                                        {prefix + "stage[1].filter.order", "1"},
                                                        {prefix + "stage[1].filter.fg_f0", "11.4"},
                                                        {prefix + "stage[1].filter.q_factor", "2"},
                                                        {prefix + "stage[1].filter.damping", "0.8"},
                                                        {prefix + "stage[1].weight_fact_num", "1750"},
                                                        {prefix + "stage[1].weight_fact_denom", "1000"}});
  CHECK(short_name(control, Language::english) ==
        "INDIRECT 11.4 Hz, order 1, quality 2, damping 0.8, weight 1.75");
  CHECK(short_name(control, Language::german) ==
        "INDIRECT 11,4 Hz, Ordnung 1, Güte 2, Dämpfung 0,8, Gewicht 1,75");
}

}  // namespace axisc::tuning::position_control_test
