#include "analysis/motion/closed_loop.hpp"

#include "analysis/motion/spectrum.hpp"
#include "channels.hpp"
#include "codegen/image_writer.hpp"
#include "support/catch.hpp"
#include "support/step_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::motion::closed_loop_test {
namespace {

constexpr double pi = std::numbers::pi;

PlantParameters two_masses() {
  PlantParameters plant;
  plant.motor_mass = 500;
  plant.load_mass = 800;
  plant.stiffness = 800 * std::pow(2 * pi * 40, 2);
  plant.damping = 2000;
  plant.velocity_bandwidth = 60;
  plant.dead_time = 0.001;
  plant.kv = 20;
  return plant;
}

/// One axis whose stage feeds its oscillating load velocity back.
image::RuntimeHost runtime(double weight, double frequency) {
  auto machine = test::channel_of({{.order = 0}});
  machine::PositionControlStage stage;
  stage.mode = machine::StageMode::direct;
  stage.filters = {{.type = design::FilterType::bandpass,
                    .prototype = design::Prototype::butterworth,
                    .order = 1,
                    .frequency = {frequency},
                    .quality = 3}};
  stage.weight_numerator = weight;
  machine.axes[0].position_control = {.stages = {stage}, .limit_factor = 1000};
  machine.axes[0].drive_scaling.controller = machine::PositionController::drive;
  auto host = image::RuntimeHost::create(codegen::write_image(machine, {}));
  REQUIRE(std::holds_alternative<image::RuntimeHost>(host));
  return std::get<image::RuntimeHost>(std::move(host));
}

AxisMove move_of(double distance_mm) {
  return {.axis = 0, .distance = distance_mm * 1e4, .velocity = 3000, .dynamics = test::step_dynamics(30)};
}

}  // namespace

TEST_CASE("the spectrum finds sines by frequency and amplitude") {
  std::vector<double> record;
  for (int n = 0; n < 1000; ++n) {
    record.push_back(5 + 0.8 * std::sin(2 * pi * 53 * n * 0.001) + 0.3 * std::cos(2 * pi * 11 * n * 0.001));
  }
  auto const found = dominant_oscillation(record, 0.001, 4, 200);
  CHECK(found.frequency == Approx(53).margin(0.05));
  CHECK(found.amplitude == Approx(0.8).epsilon(0.01));
  CHECK(amplitude_at(record, 0.001, 11) == Approx(0.3).epsilon(0.01));
  CHECK(amplitude_at({}, 0.001, 11) == 0);
}

TEST_CASE("a load swings on a motor that holds its place") {
  auto parameters = two_masses();
  parameters.velocity_bandwidth = 2000;
  parameters.dead_time = 0;
  parameters.damping = 500;
  Plant plant(parameters, 0.001);
  // A jolt of the motor, and rest: sqrt(c / m_L) / 2π = 40 Hz
  for (int n = 0; n < 5; ++n) plant.step(0.1);
  std::vector<double> acceleration;
  for (int n = 0; n < 400; ++n) {
    plant.step(0);
    acceleration.push_back(plant.motion().load_acceleration);
  }
  CHECK(dominant_oscillation(acceleration, 0.001, 4, 200).frequency == Approx(40).epsilon(0.02));
}

TEST_CASE("the dead time passes before a command is felt") {
  auto parameters = two_masses();
  parameters.dead_time = 0.003;
  Plant plant(parameters, 0.001);
  for (int n = 0; n < 3; ++n) plant.step(1);
  CHECK(plant.motion().motor_velocity == 0);
  plant.step(1);
  CHECK(plant.motion().motor_velocity > 0);
}

TEST_CASE("a plant without teeth moves as one whose teeth are perfect but for nothing") {
  auto parameters = two_masses();
  parameters.structure_mass = 300;
  parameters.structure_frequency = 12;
  parameters.structure_damping = 0.02;
  parameters.velocity_reset_time = 0.02;
  for (double const dead_time : {0.0, 0.00025, 0.001, 0.0023125}) {
    INFO(dead_time);
    parameters.dead_time = dead_time;
    auto toothed = parameters;
    toothed.tooth_pitch = 0.01;
    toothed.transmission_error = 1e-18;
    Plant linear(parameters, 0.001);
    Plant integrated(toothed, 0.001);
    for (int n = 0; n < 500; ++n) {
      double const velocity = n < 200 ? std::sin(0.05 * n) : 0;
      linear.step(velocity);
      integrated.step(velocity);
      CHECK(linear.motion().load_position == Approx(integrated.motion().load_position).margin(1e-12));
      CHECK(linear.motion().structure_velocity ==
            Approx(integrated.motion().structure_velocity).margin(1e-10));
      CHECK(linear.motion().load_acceleration == Approx(integrated.motion().load_acceleration).margin(1e-8));
    }
  }
}

TEST_CASE("the load ends where the setpoint does") {
  auto host = runtime(0.01, 40);
  auto const record = simulate_loop(host, move_of(100), two_masses(), false);
  REQUIRE_FALSE(record.lost);
  double farthest = 0;
  for (auto const& cycle : record.cycles) farthest = std::max(farthest, cycle.load_position);
  CHECK(farthest == Approx(1e6).epsilon(0.02));
  CHECK(std::abs(record.cycles.back().load_position) < 100);
  CHECK_FALSE(diverges(record, 0.001));
  CHECK(record.cycles.front().phase == MovePhase::ramp);
  CHECK(record.cycles.back().phase == MovePhase::rest);
}

TEST_CASE("the axis moves with the slope of its channel") {
  // TRAPEZ, 3000 mm/s², 50 ms to build up, 30 ms to take back: 300 mm/s after 100 + (50 + 30) / 2 cycles.
  auto move = move_of(100);
  move.dynamics.channel.slope = machine::Slope::trapez;
  auto& feed = move.dynamics.axes[0].feed;
  feed.up = {.acceleration = 3000, .build_up = 50'000, .take_back = 30'000};
  feed.down = {.acceleration = 3000, .build_up = 20'000, .take_back = 20'000};
  auto host = runtime(0.01, 40);
  auto const record = simulate_loop(host, move, two_masses(), false);
  auto const first_travel =
      std::find_if(record.cycles.begin(), record.cycles.end(),
                   [](LoopCycle const& cycle) { return cycle.phase == MovePhase::travel; });
  CHECK(first_travel - record.cycles.begin() == 139);
  double steepest = 0;
  double largest_jerk = 0;
  for (std::size_t n = 3; n < 600; ++n) {
    auto const s = [&](std::size_t back) { return record.cycles[n - back].setpoint; };
    steepest = std::max(steepest, std::abs(s(0) - 2 * s(1) + s(2)));
    largest_jerk = std::max(largest_jerk, std::abs(s(0) - 3 * s(1) + 3 * s(2) - s(3)));
  }
  // Units per cycle²; braking builds up in 20 ms.
  CHECK(steepest <= 30 * (1 + 1e-9));
  CHECK(largest_jerk == Approx(30.0 / 20));
}

TEST_CASE("weights raised far enough make the loop diverge") {
  auto gentle = runtime(0.05, 44);
  CHECK_FALSE(diverges(simulate_loop(gentle, move_of(100), two_masses(), true), 0.001));
  auto harsh = runtime(7, 44);
  auto const record = simulate_loop(harsh, move_of(100), two_masses(), true);
  CHECK(diverges(record, 0.001));
  double largest = 0;
  for (auto const& cycle : record.cycles) largest = std::max(largest, std::abs(cycle.additive_velocity));
  CHECK(largest == Approx(500'000));  // limited to vb_max
}

TEST_CASE("a position loop has a highest Kv") {
  auto host = runtime(0.01, 40);
  auto slow = two_masses();
  slow.velocity_bandwidth = 15;
  auto const found = highest_kv(host, move_of(50), slow, false);
  REQUIRE(found.has_value());
  double const kv = *found;
  CHECK(kv > 10);
  slow.kv = kv * 1.1;
  CHECK(diverges(simulate_loop(host, move_of(50), slow, false), 0.001));
  slow.kv = kv * 0.9;
  CHECK_FALSE(diverges(simulate_loop(host, move_of(50), slow, false), 0.001));
}

TEST_CASE("a loop that outlives the search has no highest Kv") {
  // Load and motor are one, and the drive follows at once: a sampled integrator, stable up to Kv T = 2.
  auto stiff = two_masses();
  stiff.stiffness = 1e11;
  stiff.damping = 1e6;
  stiff.velocity_bandwidth = 1500;
  stiff.dead_time = 0;
  auto host = runtime(0.01, 40);
  CHECK_FALSE(highest_kv(host, move_of(50), stiff, false).has_value());
  // Two cycles of dead time more: x[n+1] = x[n] - Kv T x[n-2] is stable up to Kv T = 2 sin(π/10).
  stiff.dead_time = 0.002;
  auto const found = highest_kv(host, move_of(50), stiff, false);
  REQUIRE(found.has_value());
  CHECK(*found == Approx(1000 * 2 * std::sin(pi / 10)).epsilon(0.1));
}

}  // namespace axisc::motion::closed_loop_test
