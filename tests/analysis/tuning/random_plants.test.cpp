// What is suggested for random machines, tried on their simulated mechanics.
#include "analysis/motion/interpolator.hpp"
#include "analysis/motion/look_ahead.hpp"
#include "analysis/tuning/suggestion/choice.hpp"
#include "analysis/tuning/suggestion/list_lines.hpp"
#include "codegen/image_writer.hpp"
#include "image/runtime_host.hpp"
#include "random_tasks.hpp"
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "support/sanitized.hpp"
#include "swinging_load.hpp"

#include <fmt/format.h>

namespace axisc::random_plants_test {
namespace {

using tuning::Candidate;
using tuning::Task;

struct Recorder final : motion::SampleSink {
  void sample(motion::Point const& setpoint, double, motion::PathBlock const&) override {
    setpoints.push_back(setpoint[0]);
  }
  void corner(motion::PathBlock const&, motion::PathBlock const*, double,
              motion::BlockMotion const&) override {}
  std::vector<double> setpoints;
};

/// The planner's way from rest to the task's velocity, and so many cycles on.
std::vector<double> planned_ramp(Task const& task, std::size_t cycles) {
  Recorder recorder;
  motion::Interpolator interpolator(recorder);
  motion::LookAhead look_ahead(motion::PathLimits(task.dynamics), false, interpolator);
  look_ahead.begin({}, {}, 1);
  motion::ProgrammedBlock block;
  // So long that braking begins after everything that is looked at.
  double const ramp = task.velocity / test::step_acceleration(task.dynamics);
  block.feed = task.velocity;
  block.end[0] = task.velocity * (2 * ramp + static_cast<double>(cycles) + 10);
  look_ahead.add(block);
  look_ahead.stop();
  recorder.setpoints.resize(std::min(recorder.setpoints.size(), cycles));
  return recorder.setpoints;
}

/// Setpoints behind the chain as the lists' machine would run it.
std::vector<double> filtered(std::vector<double> setpoints, tuning::Chain const& chain, Task const& task) {
  machine::Machine machine;
  machine.cycle_time = task.cycle_time;
  machine::AxisConfiguration axis;
  axis.name = "X";
  std::uint32_t index = 0;
  for (auto const& filter : chain.filters)
    axis.filters.push_back({.index = index++, .specification = filter});
  if (chain.kernel) {
    axis.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::fir,
                                            .index = 0,
                                            .specification = *chain.kernel,
                                            .on_at_start = true};
  }
  machine.axes.push_back(axis);
  auto host = image::RuntimeHost::create(codegen::write_image(machine, {}));
  REQUIRE(std::holds_alternative<image::RuntimeHost>(host));
  auto& runtime = std::get<image::RuntimeHost>(host);
  REQUIRE(runtime.reset_all(0) == AXISRT_OK);
  for (auto& setpoint : setpoints) {
    REQUIRE(runtime.step(std::span(&setpoint, 1), std::span(&setpoint, 1)) == AXISRT_OK);
  }
  return setpoints;
}

void check_vibration(Task const& task, Candidate const& candidate) {
  double const T = task.cycle_time.seconds();
  auto const ramp =
      static_cast<std::size_t>(std::ceil(task.velocity / test::step_acceleration(task.dynamics) - 1e-9));
  auto const rest = ramp + static_cast<std::size_t>(std::ceil(2 * candidate.figures.delay - 1e-6));
  auto const setpoints = planned_ramp(task, rest + 400);
  auto const out = filtered(setpoints, candidate.chain, task);
  for (std::size_t i = 0; i < task.resonances.size(); ++i) {
    auto const& promised = candidate.figures.resonances[i];
    auto const& resonance = task.resonances[i];
    double const unfiltered = test::swing_at(setpoints, ramp, resonance, T);
    double largest = 0;
    for (std::size_t n = rest; n < rest + 60; n += 2) {
      largest = std::max(largest, test::swing_at(out, n, resonance, T));
    }
    INFO(fmt::format("{:.1f} Hz D {:.3f}: {}", resonance.frequency, *resonance.damping,
                     tuning::short_name(candidate.chain, Language::english)));
    // What the drive's lag of a tenth of a millisecond makes is below half a percent of the unfiltered swing.
    double const blur = 0.005 * task.velocity / (2 * std::numbers::pi * resonance.frequency * T);
    CHECK(unfiltered == Approx(promised.unfiltered).epsilon(0.1).margin(blur));
    CHECK(largest == Approx(promised.amplitude).epsilon(0.1).margin(blur));
  }
}

/// A machine of two axes with the suggested lines in both lists has no findings.
void check_lists(Task const& task, Candidate const& candidate) {
  std::map<std::string, std::string> files;
  std::string lines;
  for (auto const& [name, value] : tuning::list_lines(candidate.chain, task.family)) {
    lines += name + " " + value + "\n";
  }
  for (std::string const axis : {"x", "y"}) {
    files[axis + ".lis"] = "kopf.achs_nr " + std::string(axis == "x" ? "1" : "2") +
                           "\nkenngr.achs_typ 1\ngetriebe[0].dynamik.vb_max 500000\n" + lines + "Ende\n";
  }
  files["m.json"] = fmt::format(
      R"({{"machine": "m", "cycle_time_us": {}, "axes": [{{"name": "X", "list": "x.lis"}}, {{"name": "Y", "list": "y.lis"}}]}})",
      task.cycle_time.microseconds());
  INFO(lines);
  CHECK(tests::Checked(files, "m.json", {}).found() == std::vector<std::string>{});
}

/// True where something was suggested.
bool check_task(Task const& task) {
  tuning::Judge const judge(task);
  auto enumeration = tuning::enumerate(task, judge);
  auto const choice = tuning::choose(enumeration.candidates, judge, task.goal);
  if (!choice) return false;
  for (auto const& candidate : choice->chosen) {
    CHECK(candidate.is_clean);
    CHECK(candidate.figures.circle <= task.tolerance);
    CHECK(candidate.figures.vibration <= tuning::useful_vibration);
    check_lists(task, candidate);
    check_vibration(task, candidate);
  }
  auto const& [deviation, balanced, vibration] = choice->chosen;
  CHECK(deviation.figures.corner <= balanced.figures.corner * (1 + 1e-12));
  CHECK(vibration.figures.vibration <= balanced.figures.vibration + 6e-4);
  return true;
}

}  // namespace

TEST_CASE("suggestions keep on the simulated mechanics what they promise") {
  constexpr std::uint32_t machines = test::sanitized ? 2 : 6;
  std::size_t chosen = 0;
  for (std::uint32_t seed = 1; seed <= machines; ++seed) {
    INFO("seed " << seed);
    chosen += check_task(test::random_task(seed)) ? 1 : 0;
  }
  CHECK(2 * chosen >= machines);
}

TEST_CASE("suggestions keep their promise on five hundred machines", "[.][long]") {
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    INFO("seed " << seed);
    static_cast<void>(check_task(test::random_task(seed)));
  }
}

}  // namespace axisc::random_plants_test
