#include "analysis/motion/axis_ramps.hpp"
#include "analysis/tuning/suggestion/choice.hpp"
#include "analysis/tuning/suggestion/excitation.hpp"
#include "analysis/tuning/suggestion/list_lines.hpp"
#include "analysis/tuning/suggestion/ramp_candidates.hpp"
#include "analysis/tuning/suggestion/ramp_envelope.hpp"
#include "random_tasks.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/step_dynamics.hpp"

#include <array>
#include <complex>
#include <numbers>

namespace axisc::tuning::suggestion_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double units_per_mm = 1e4;

/// 48 Hz, F4000, 2 m/s², T = 1 ms.
Task one_resonance() {
  return {.cycle_time = {1'000'000},
          .resonances = {{.frequency = 48, .damping = 0.03}},
          .velocity = 4000.0 / 60 * units_per_mm * 1e-3,
          .dynamics = test::step_dynamics(2000 * units_per_mm * 1e-6),
          .tolerance = 0.01 * units_per_mm,
          .radius = 10 * units_per_mm};
}

/// Taps b[0] to b[2h] of the definitions, summed to 1.
std::vector<double> plain_kernel(design::KernelSpecification const& kernel, double T) {
  auto const h = static_cast<int>(kernel.order / 2);
  std::vector<double> taps;
  double sum = 0;
  for (int k = -h; k <= h; ++k) {
    double tap = 1;
    if (kernel.type == design::KernelType::gaussian) {
      double const sigma = kernel.quality * h / 2.5;
      tap = std::exp(-0.5 * k * k / sigma / sigma);
    } else if (kernel.type == design::KernelType::windowed_sinc) {
      double const x = 2 * kernel.frequency.value * T * k * pi;
      tap = (x == 0 ? 1 : std::sin(x) / x) * (0.54 + 0.46 * std::cos(pi * k / h));
    }
    taps.push_back(tap);
    sum += tap;
  }
  for (auto& tap : taps) tap /= sum;
  return taps;
}

/// Velocity jumps of a ramp to the task's velocity, filtered.
std::vector<double> plain_jumps(std::vector<double> const& taps, Task const& task) {
  double const acceleration = test::step_acceleration(task.dynamics);
  double const duration = task.velocity / acceleration;
  auto const ramp = static_cast<std::size_t>(std::ceil(duration - 1e-9));
  auto const way = [&](double t) {
    return t < duration ? acceleration * t * t / 2
                        : task.velocity * duration / 2 + task.velocity * (t - duration);
  };
  std::vector<double> jumps(taps.size() + ramp);
  for (std::size_t k = 0; k < taps.size(); ++k) {
    for (std::size_t n = 0; n <= ramp; ++n) {
      double const t = static_cast<double>(n);
      jumps[k + n] += taps[k] * (way(t + 1) - 2 * way(t) + (n > 0 ? way(t - 1) : 0));
    }
  }
  return jumps;
}

/// Largest swing behind a ramp that a symmetrical kernel filtered, by the sum of what each velocity jump
/// leaves: no recursion, no runtime, and frequencies and dampings so close to each other that nothing is
/// between them.
double plain_swing(std::vector<double> const& taps, Task const& task, int frequencies, int dampings) {
  double const T = task.cycle_time.seconds();
  auto const jumps = plain_jumps(taps, task);
  double worst = 0;
  for (int i = 0; i <= frequencies; ++i) {
    for (int j = 0; j <= dampings; ++j) {
      double const damping = 0.02 + 0.18 * j / dampings;
      double const omega = 2 * pi * (0.9 + 0.2 * i / frequencies) * task.resonances[0].frequency;
      double const damped = omega * std::sqrt(1 - damping * damping);
      auto const p = std::exp(std::complex<double>(-damping * omega, damped) * T);
      std::complex<double> power = 1;
      std::complex<double> left = 0;
      for (std::size_t n = jumps.size(); n-- > 0; power *= p) left += jumps[n] * power;
      worst = std::max(worst, std::abs(left) / damped / T);
    }
  }
  return worst;
}

/// Of a symmetrical kernel at 90°: 2 R(0) sin(45°), R(0) = Σ k b[k].
double plain_corner(std::vector<double> const& taps) {
  auto const h = static_cast<std::ptrdiff_t>(taps.size() / 2);
  double sum = 0;
  for (std::ptrdiff_t k = 1; k <= h; ++k) {
    sum += static_cast<double>(k) * taps[static_cast<std::size_t>(h + k)];
  }
  return std::numbers::sqrt2 * sum;
}

}  // namespace

TEST_CASE("a ramp's slope excites a resonance by its envelope") {
  // Long after a change whose acceleration begins and ends in tr, an undamped resonance swings at most as
  // after STEP times |sin x / x|, x = π f tr, with sin² |cos x / (1 - (2x/π)²)|. 48 Hz and 50 ms: 0.126 and
  // 0.0140. Which part of it shows depends on how long the acceleration lasts: the largest over those from 70
  // to 91 ms.
  auto const largest = [](machine::Slope slope) {
    double most = 0;
    for (int hold = 20; hold <= 41; ++hold) {
      Task task = one_resonance();
      task.resonances[0].damping = 1e-6;
      task.dynamics.channel.slope = slope;
      auto& ramp = task.dynamics.axes[0].feed.up;
      ramp = {.acceleration = 2000, .build_up = 50'000, .take_back = 50'000};
      task.dynamics.axes[0].feed.down = ramp;
      task.velocity = test::step_acceleration(task.dynamics) * (50 + hold);
      most = std::max(most, Excitation(task).after({.taps = {1}, .delay = 0}).at(0).unfiltered);
    }
    return most;
  };
  double const step = largest(machine::Slope::step);
  CHECK(largest(machine::Slope::trapez) / step == Approx(0.126).epsilon(0.02));
  CHECK(largest(machine::Slope::sin2) / step == Approx(0.0140).epsilon(0.02));
}

TEST_CASE("the envelopes at 48 Hz and 50 ms, at 0 and at their zeros, by hand") {
  double const x = pi * 48 * 0.05;
  CHECK(trapez_envelope(x) == Approx(0.126).epsilon(2e-3));
  CHECK(sine_envelope(x) == Approx(0.0140).epsilon(2e-3));
  CHECK(trapez_envelope(0) == 1);
  CHECK(sine_envelope(0) == 1);
  CHECK(sine_envelope(pi / 2) == Approx(pi / 4));
  CHECK(trapez_envelope(pi) == Approx(0).margin(1e-12));
  CHECK(sine_envelope(1.5 * pi) == Approx(0).margin(1e-12));
  // 50 ms and 30 ms: the mean of both ends. A change of a quarter of a t̄/2 has ramps of half the times.
  auto const ramp = [](double first, double second) {
    return motion::Ramp({.acceleration = 20, .at_slow_end = first, .at_fast_end = second}, {});
  };
  double const theta = 2 * pi * 0.048;
  CHECK(envelope(ramp(50, 30), 2000, theta) ==
        Approx((trapez_envelope(x) + trapez_envelope(pi * 48 * 0.03)) / 2));
  CHECK(envelope(ramp(50, 50), 20 * 50 / 4.0, theta) == Approx(trapez_envelope(x / 2) / 2));
  CHECK(envelope(motion::axis_ramps(test::step_dynamics(20)).up, 2000, theta) == 1);
}

TEST_CASE("the ramp that excites more counts, whether the axis accelerates or brakes") {
  auto const swing_of = [](Task const& task) {
    return Excitation(task).after({.taps = {1}, .delay = 0}).at(0).unfiltered;
  };
  auto const with_accelerations = [](double up, double down) {
    auto task = one_resonance();
    auto& feed = task.dynamics.axes[0].feed;
    feed.step_up = {.first = up, .second = up};
    feed.step_down = {.first = down, .second = down};
    return task;
  };
  double const slow = swing_of(with_accelerations(1300, 1300));
  double const quick = swing_of(with_accelerations(6000, 6000));
  REQUIRE(std::abs(slow - quick) > 0.1 * slow);
  CHECK(swing_of(with_accelerations(1300, 6000)) == Approx(std::max(slow, quick)));
  CHECK(swing_of(with_accelerations(6000, 1300)) == Approx(std::max(slow, quick)));
}

TEST_CASE("ramp times are zeros of the envelope, and their share is that of their own ramps") {
  auto task = one_resonance();
  CHECK_FALSE(ramp_candidates(task, Excitation(task)).has_value());
  task.dynamics.channel.slope = machine::Slope::trapez;
  auto& axis = task.dynamics.axes[0];
  axis.feed.up = axis.feed.down = {.acceleration = 1000, .build_up = 12'000, .take_back = 12'000};
  auto const found = ramp_candidates(task, Excitation(task));
  REQUIRE(found.has_value());
  REQUIRE(found->candidates.size() == 3);
  // n / 48 Hz in µs, rounded up; v/a + tr.
  CHECK(found->candidates[0].ramp_time == 20834);
  CHECK(found->candidates[2].ramp_time == 62500);
  CHECK(found->up_time == Approx(66.6667 + 12).epsilon(1e-5));
  CHECK(found->candidates[1].down_time == Approx(66.6667 + 41.667).epsilon(1e-5));
  REQUIRE(found->quickest.has_value());
  auto other = task;
  for (auto* const ramp : {&other.dynamics.axes[0].feed.up, &other.dynamics.axes[0].feed.down}) {
    ramp->build_up = ramp->take_back = found->candidates[0].ramp_time;
  }
  CHECK(found->candidates[0].vibration == Approx(Excitation(other).beside(Excitation(task))[0].worst));
  for (std::size_t i = 0; i < *found->quickest; ++i) {
    CHECK(found->candidates[i].vibration > sufficient_vibration);
  }
  CHECK(found->candidates[*found->quickest].vibration <= sufficient_vibration);
  // None is shorter than P-AXIS-00201.
  axis.shortest_ramp_time = 30'000;
  CHECK(ramp_candidates(task, Excitation(task))->candidates.size() == 2);
}

TEST_CASE(
    "every kernel of an enumeration has the figures of its definition, and none is better than the chosen") {
  auto const task = one_resonance();
  double const T = task.cycle_time.seconds();
  Judge const judge(task);
  auto found = enumerate(task, judge);
  auto const choice = choose(found.candidates, judge, task.goal);
  REQUIRE(choice);
  constexpr int frequencies = 80;
  constexpr int dampings = 8;
  double const unfiltered = plain_swing({1.0}, task, frequencies, dampings);
  double const least = choice->chosen[2].figures.vibration;
  std::size_t kernels = 0;
  for (std::uint32_t order = 2; order <= 200; order += 2) {
    for (auto const type : {design::KernelType::moving_average, design::KernelType::gaussian}) {
      design::KernelSpecification const kernel{.type = type, .order = order};
      auto const taps = plain_kernel(kernel, T);
      double gain = 0;
      for (std::size_t k = 0; k < taps.size(); ++k) {
        gain += taps[k] * std::cos(task.velocity / task.radius *
                                   (static_cast<double>(k) - static_cast<double>(order) / 2));
      }
      double const circle = task.radius * std::abs(1 - std::abs(gain));
      auto const same =
          std::find_if(found.candidates.begin(), found.candidates.end(), [&](Candidate const& candidate) {
            return candidate.chain.filters.empty() && candidate.chain.kernel == kernel;
          });
      bool const keeps = circle <= task.tolerance;
      INFO(order);
      REQUIRE((same != found.candidates.end()) == keeps);
      if (!keeps) continue;
      ++kernels;
      settle(*same, judge);
      double const vibration = plain_swing(taps, task, frequencies, dampings) / unfiltered;
      double const corner = plain_corner(taps);
      CHECK(same->figures.circle == Approx(circle).epsilon(1e-6));
      CHECK(same->figures.corner == Approx(corner).epsilon(1e-6));
      // Between the frequencies of the sum it may be a little larger.
      CHECK(same->figures.vibration >= vibration * (1 - 1e-3) - 1e-6);
      CHECK(same->figures.vibration <= vibration * (1 + 1e-3) + 1e-4);
      CHECK(vibration >= least * (1 - 1e-3) - 6e-4);
      if (vibration <= sufficient_vibration * 0.999) {
        CHECK(corner >= choice->chosen[0].figures.corner * (1 - 1e-6));
      }
      if (vibration <= sufficient_vibration * 0.999) {
        CHECK(corner * (std::pow(vibration, 1.5) + 0.2 * vibration + 0.01) >=
              balance(choice->chosen[1].figures, {}) * (1 - 1e-6));
      }
    }
  }
  CHECK(kernels > 10);
}

TEST_CASE("the worst case is the largest swing of the whole band of frequencies and dampings") {
  struct Row {
    double resonance, feed, acceleration;  // Hz, mm/min, mm/s²
    design::KernelSpecification kernel;
  };
  // The largest swing lies between the frequencies and dampings of any coarse grid: next to notches of the
  // kernel.
  for (auto const& row :
       {Row{48, 4000, 3000, {.type = design::KernelType::windowed_sinc, .order = 42, .frequency = {24}}},
        Row{48, 4000, 3000, {.type = design::KernelType::moving_average, .order = 20}},
        Row{120, 6000, 5000, {.type = design::KernelType::moving_average, .order = 24}},
        Row{17, 2000, 500, {.type = design::KernelType::gaussian, .order = 150}},
        Row{310, 9000, 9000, {.type = design::KernelType::moving_average, .order = 6}}}) {
    INFO(row.resonance);
    auto task = one_resonance();
    task.resonances = {{.frequency = row.resonance}};
    task.velocity = row.feed / 60 * units_per_mm * 1e-3;
    task.dynamics = test::step_dynamics(row.acceleration * units_per_mm * 1e-6);
    auto const taps = plain_kernel(row.kernel, task.cycle_time.seconds());
    constexpr int frequencies = 1600;
    constexpr int dampings = 40;
    double const dense = plain_swing(taps, task, frequencies, dampings);
    double const unfiltered = plain_swing({1.0}, task, frequencies, dampings);
    Chain const chain{.kernel = row.kernel};
    auto const response = impulse_responses(std::span(&chain, 1), task.cycle_time).front();
    CHECK(Judge(task).figures(response).vibration == Approx(dense / unfiltered).epsilon(2e-4).margin(2e-6));
  }
}

TEST_CASE(
    "the deviation at the corner is that of the filtered path, also of chains that are not symmetrical") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    auto const frequency = 20.0 + 3 * seed;
    Chain chain{.filters = {{.order = 1 + seed % 6, .frequency = {frequency}}}};
    if (seed % 2 == 1) chain.kernel = design::KernelSpecification{.order = 2 + 2 * (seed % 20)};
    auto const response = impulse_responses(std::span(&chain, 1), {1'000'000}).front();
    // y(t) = Σ b[k] max(0, t - k), x(t) = t - delay - y(t): the corner's distance from the path, looked for
    // in tenths of a cycle.
    double nearest = response.delay;
    for (double t = 0; t < 4 * response.delay + 20; t += 0.1) {
      double y = 0;
      for (std::size_t k = 0; k < response.taps.size(); ++k) {
        y += response.taps[k] * std::max(0.0, t - static_cast<double>(k));
      }
      nearest = std::min(nearest, std::hypot(t - response.delay - y, y));
    }
    INFO(seed);
    CHECK(Judge(one_resonance()).figures(response).corner == Approx(nearest).epsilon(1e-3));
  }
}

TEST_CASE("the three senses are optimal among all candidates that a list may set without a finding") {
  // Of each task a part of the candidates: settling one takes a millisecond, and there are up to a hundred
  // thousand.
  constexpr std::size_t looked_at = test::sanitized ? 50 : 400;
  for (std::uint32_t seed = 100; seed < 104; ++seed) {
    INFO(seed);
    auto task = test::random_task(seed);
    task.goal = seed % 2 == 0 ? std::optional(Goal::speed) : std::nullopt;
    Judge const judge(task);
    auto found = enumerate(task, judge);
    auto const choice = choose(found.candidates, judge, task.goal);
    if (!choice) continue;
    std::size_t const stride = 1 + found.candidates.size() / looked_at;
    // Settled here, not only those that seemed to be among the best.
    for (std::size_t i = seed % stride; i < found.candidates.size(); i += stride) {
      auto& candidate = found.candidates[i];
      auto const estimate =
          candidate.is_settled
              ? judge.estimate(candidate.second ? in_series(*candidate.first, *candidate.second)
                                                : *candidate.first)
              : candidate.figures;
      settle(candidate, judge);
      CHECK(estimate.vibration <= candidate.figures.vibration * (1 + 1e-9));
      CHECK(estimate.corner <= candidate.figures.corner * (1 + 1e-6) + 1e-9);
    }
    auto const price = [&](Figures const& figures) { return task.goal ? figures.delay : figures.corner; };
    auto const& [deviation, balanced, vibration] = choice->chosen;
    std::size_t better_balanced = 0, calmer = 0, cheaper = 0;
    double least = 1;
    for (auto const& candidate : found.candidates) {
      if (candidate.is_clean && candidate.is_settled) least = std::min(least, candidate.figures.vibration);
    }
    double const same = least + 5e-4;
    for (auto const& candidate : found.candidates) {
      auto const& figures = candidate.figures;
      if (!candidate.is_clean || !candidate.is_settled || figures.vibration > std::max(0.25, same)) continue;
      better_balanced += balance(figures, task.goal) < balance(balanced.figures, task.goal) ? 1 : 0;
      cheaper +=
          figures.vibration <= std::max(0.25, same) && price(figures) < price(deviation.figures) ? 1 : 0;
      calmer += figures.vibration <= same && price(figures) < price(vibration.figures) ? 1 : 0;
    }
    CHECK(better_balanced == 0);
    CHECK(cheaper == 0);
    CHECK(calmer == 0);
    CHECK(vibration.figures.vibration <= same);
  }
}

TEST_CASE("goals choose what is recommended") {
  auto const task = one_resonance();
  Judge const judge(task);
  auto found = enumerate(task, judge);
  auto const chosen = [&](std::optional<Goal> goal) { return *choose(found.candidates, judge, goal); };
  CHECK(chosen(std::nullopt).recommended == Sense::balanced);
  CHECK(chosen(Goal::surface).recommended == Sense::least_vibration);
  CHECK(chosen(Goal::accuracy).recommended == Sense::least_deviation);
  CHECK(chosen(Goal::speed).recommended == Sense::balanced);
  CHECK(chosen(Goal::speed).chosen[0].figures.delay <= chosen(std::nullopt).chosen[0].figures.delay);
}

TEST_CASE("nothing is chosen where every chain violates the tolerance") {
  auto task = one_resonance();
  task.tolerance = 1e-3;
  Judge const judge(task);
  auto found = enumerate(task, judge);
  CHECK(found.looked_at > 1000);
  CHECK_FALSE(choose(found.candidates, judge, task.goal));
}

TEST_CASE("a resonance whose frequency is uncertain is judged over a wider band") {
  auto task = one_resonance();
  Judge const sure(task);
  task.resonances[0].uncertainty = 6;
  Judge const unsure(task);
  Chain const chain{.kernel = design::KernelSpecification{.order = 20}};
  auto const response = impulse_responses(std::span(&chain, 1), task.cycle_time).front();
  CHECK(unsure.figures(response).vibration > 1.2 * sure.figures(response).vibration);
}

TEST_CASE("an empty chain leaves everything as it is") {
  auto const task = one_resonance();
  auto const figures = Judge(task).figures({});
  CHECK(figures.vibration == Approx(1));
  CHECK(figures.corner == 0);
  CHECK(figures.circle == Approx(0).margin(1e-9));
  CHECK(figures.resonances[0].amplitude == figures.resonances[0].unfiltered);
}

TEST_CASE("a chain becomes lines of a list") {
  Chain const chain{.filters = {{.order = 2, .frequency = {30.5}}},
                    .kernel = design::KernelSpecification{
                        .type = design::KernelType::gaussian, .order = 40, .quality = 0.8}};
  CHECK(list_lines(chain, machine::KernelFamily::fir) ==
        std::vector<ListLine>{{"filter[0].enable", "1"},
                              {"filter[0].type", "LOWPASS"},
                              {"filter[0].prototype", "CRIT_DAMPING"},
                              {"filter[0].order", "2"},
                              {"filter[0].fg_f0", "30.5"},
                              {"filter[0].share_percent", "100"},
                              {"filter_fir.enable", "1"},
                              {"filter_fir.type", "2"},
                              {"filter_fir.order", "40"},
                              {"filter_fir.quality", "0.8"},
                              {"filter_fir.share", "100"}});
  CHECK(filter_command(chain, machine::KernelFamily::fir, 0.01) == "#FILTER ON [AX_DEV=0.01]");
  CHECK(short_name(chain, Language::english) == "LOWPASS order 2, 30.5 Hz + Gaussian order 40, quality 0.8");
  CHECK_FALSE(filter_command({.filters = chain.filters}, machine::KernelFamily::fir, 0.01));
  Chain const shaper{.filters = chain.filters,
                     .kernel = design::KernelSpecification{
                         .type = design::KernelType::novib, .order = 1, .frequency = {48}}};
  CHECK(filter_command(shaper, machine::KernelFamily::hsc, 0.01) == "#FILTER ON [HSC]");
  auto const lines = list_lines(shaper, machine::KernelFamily::hsc);
  CHECK(lines.front() == ListLine{"filter[0].prototype", "HSC"});
  CHECK(lines[5] == ListLine{"filter[1].enable", "1"});
}

}  // namespace axisc::tuning::suggestion_test
