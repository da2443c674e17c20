// Vibration Guard among the candidates, against the impulses of the manual's modes as input shapers.
#include "analysis/tuning/suggestion/guard_candidates.hpp"

#include "analysis/tuning/suggestion/choice.hpp"
#include "analysis/tuning/suggestion/list_lines.hpp"
#include "support/catch.hpp"
#include "support/step_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace axisc::tuning::guard_candidates_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double units_per_mm = 1e4;

/// 48 Hz, F1000, 2 m/s², T = 1 ms; the wide circle lets every mode keep the tolerance.
Task one_resonance(std::optional<double> damping = 0.03) {
  return {.cycle_time = {1'000'000},
          .resonances = {{.frequency = 48, .damping = damping}},
          .velocity = 1000.0 / 60 * units_per_mm * 1e-3,
          .dynamics = test::step_dynamics(2000 * units_per_mm * 1e-6),
          .tolerance = 0.05 * units_per_mm,
          .radius = 50 * units_per_mm};
}

std::vector<Candidate> clean_candidates(Task const& task) {
  auto found = enumerate(task, Judge(task)).candidates;
  std::erase_if(found, [](Candidate const& candidate) { return !candidate.is_clean; });
  return found;
}

std::size_t count_guards(std::vector<Candidate> const& candidates) {
  return static_cast<std::size_t>(
      std::count_if(candidates.begin(), candidates.end(),
                    [](Candidate const& candidate) { return has_guard(candidate.chain); }));
}

/// Taps on cycles: the modes' impulses, split linearly between two cycles; mode 4 symmetrical around a
/// cycle.
std::vector<double> plain_guard(int mode, double f, double D, double T) {
  double const root = std::sqrt(1 - D * D);
  double const K = std::exp(-pi * D / root);
  double const h = 1 / (2 * f * root * T);
  std::vector<double> amplitudes;
  switch (mode) {
    case 1: amplitudes = {1, K}; break;
    case 2: amplitudes = {1, 2 * K, K * K}; break;
    case 3: amplitudes = {1, 3 * K, 3 * K * K, K * K * K}; break;
    default: amplitudes = {K, 1 + K * K, K};
  }
  double sum = 0;
  for (double const amplitude : amplitudes) sum += amplitude;
  double const begin = mode == 4 ? std::ceil(h) - h : 0;
  std::vector<double> taps(static_cast<std::size_t>(std::floor(begin + 3 * h) + 3));
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    double const at = begin + static_cast<double>(i) * h;
    auto const cycle = static_cast<std::size_t>(std::floor(at));
    taps[cycle] += amplitudes[i] / sum * (1 - (at - std::floor(at)));
    taps[cycle + 1] += amplitudes[i] / sum * (at - std::floor(at));
  }
  return taps;
}

/// The largest swing from the cycle on at which a symmetrical kernel of that delay would rest, by the sum of
/// what each jump of the velocity leaves, over a grid of frequencies and dampings.
double plain_swing(std::vector<double> const& taps, Task const& task) {
  double const T = task.cycle_time.seconds();
  double const acceleration = test::step_acceleration(task.dynamics);
  double const duration = task.velocity / acceleration;
  auto const ramp = static_cast<std::size_t>(std::ceil(duration - 1e-9));
  auto const way = [&](double t) {
    return t < duration ? acceleration * t * t / 2 : task.velocity * (t - duration / 2);
  };
  double delay = 0;
  std::vector<double> jumps(taps.size() + ramp + 1);
  for (std::size_t k = 0; k < taps.size(); ++k) {
    delay += static_cast<double>(k) * taps[k];
    for (std::size_t n = 0; n <= ramp; ++n) {
      double const t = static_cast<double>(n);
      jumps[k + n] += taps[k] * (way(t + 1) - 2 * way(t) + (n > 0 ? way(t - 1) : 0));
    }
  }
  auto const rest = ramp + static_cast<std::size_t>(std::ceil(2 * delay - 1e-6));
  jumps.resize(std::max(jumps.size(), rest + 1));
  double worst = 0;
  constexpr int frequencies = 200, dampings = 9;
  for (int i = 0; i <= frequencies; ++i) {
    for (int j = 0; j <= dampings; ++j) {
      double const damping = 0.02 + 0.18 * j / dampings;
      double const omega = 2 * pi * (0.9 + 0.2 * i / frequencies) * task.resonances[0].frequency;
      double const damped = omega * std::sqrt(1 - damping * damping);
      auto const p = std::exp(std::complex<double>(-damping * omega, damped) * T);
      std::complex<double> q = 0;
      for (std::size_t n = 0; n < jumps.size(); ++n) {
        q = p * q + jumps[n];
        if (n >= rest) worst = std::max(worst, std::abs(q) / damped / T);
      }
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("guards of all modes are tried around the resonance, for known and usual dampings") {
  // 31 frequencies, 4 modes, dampings 0.03, 0.02, 0.05, 0.1; a step of 1 % is 0.48 Hz, so that none coincide.
  auto const found = guard_candidates(one_resonance());
  CHECK(found.size() == std::size_t{31} * 4 * 4);
  std::set<double> frequencies, dampings;
  std::set<std::uint32_t> modes;
  for (auto const& chain : found) {
    CHECK(chain.filters.empty());
    frequencies.insert(chain.kernel->frequency.value);
    dampings.insert(chain.kernel->quality);
    modes.insert(chain.kernel->order);
  }
  CHECK(*frequencies.begin() == Approx(40.8));
  CHECK(*frequencies.rbegin() == Approx(55.2));
  CHECK(frequencies.contains(48));
  CHECK(dampings == std::set<double>{0.02, 0.03, 0.05, 0.1});
  CHECK(modes == std::set<std::uint32_t>{1, 2, 3, 4});
  CHECK(guard_candidates(one_resonance(0.05)).size() == std::size_t{31} * 4 * 3);
  CHECK(guard_candidates(one_resonance(std::nullopt)).size() == std::size_t{31} * 4 * 3);
  // 1 % of 5 Hz is less than a tenth of a hertz.
  auto slow = one_resonance(std::nullopt);
  slow.resonances[0].frequency = 5;
  auto const slow_guards = guard_candidates(slow);
  CHECK(std::any_of(slow_guards.begin(), slow_guards.end(),
                    [](Chain const& chain) { return chain.kernel->frequency.value == 5.05; }));
}

TEST_CASE("guards that lists have findings about are not tried") {
  // T = 250 µs, mode 3: 1.5/f are 200 cycles at 30 Hz, with D = 0.02 at 30.006 Hz.
  auto task = one_resonance(std::nullopt);
  task.cycle_time = {250'000};
  task.resonances[0].frequency = 30;
  for (auto const& chain : guard_candidates(task)) {
    if (chain.kernel->order == 3) CHECK(chain.kernel->frequency.value > 30.0);
  }
  // Half a period of 4.5 cycles: the second impulse, half of all, becomes a pair with the gain
  // cos(π f T) = 0.94 at f, and 3 % are left. 5 cycles, and with 48 Hz 10.4, leave less than 2 %.
  auto const guard = [](double frequency) {
    return design::KernelSpecification{
        .type = design::KernelType::vibration_guard, .order = 1, .frequency = {frequency}, .quality = 0.02};
  };
  auto const coarse = [&](double frequency) {
    Chain const chain{.kernel = guard(frequency)};
    return is_coarse(guard(frequency), impulse_responses(std::span(&chain, 1), {1'000'000}).front(),
                     {1'000'000});
  };
  CHECK(coarse(500 / 4.5));
  CHECK_FALSE(coarse(100));
  CHECK_FALSE(coarse(48));
}

TEST_CASE("a guard is judged by what an oscillator does after a ramp that its impulses filtered") {
  auto const task = one_resonance();
  Judge const judge(task);
  double const unfiltered = plain_swing({1.0}, task);
  auto found = enumerate(task, judge);
  for (std::uint32_t mode = 1; mode <= 4; ++mode) {
    for (double const damping : {0.02, 0.1}) {
      INFO(mode << ' ' << damping);
      auto const same =
          std::find_if(found.candidates.begin(), found.candidates.end(), [&](Candidate const& candidate) {
            auto const& [filters, kernel] = candidate.chain;
            return filters.empty() && has_guard(candidate.chain) && kernel->order == mode &&
                   kernel->frequency.value == 48 && kernel->quality == damping;
          });
      REQUIRE(same != found.candidates.end());
      CHECK(same->is_clean);
      settle(*same, judge);
      auto const taps = plain_guard(static_cast<int>(mode), 48, damping, 1e-3);
      double const vibration = plain_swing(taps, task) / unfiltered;
      CHECK(same->figures.vibration >= vibration * (1 - 1e-3) - 1e-6);
      CHECK(same->figures.vibration <= vibration * (1 + 2e-3) + 1e-4);
      // h K/(1 + K) a pair; mode 4 in whole cycles: 1/96 s are 10.42 ms.
      double const root = std::sqrt(1 - damping * damping);
      double const K = std::exp(-pi * damping / root);
      double const delay = mode == 4 ? 11 : mode * 1000 / (96 * root) * K / (1 + K);
      CHECK(same->figures.delay == Approx(delay).epsilon(1e-9));
      CHECK(same->figures.overshoot == Approx(0).margin(1e-12));
    }
  }
}

TEST_CASE(
    "guards stand alone and behind low-passes, unless commands in programs or an old build exclude them") {
  // A tolerance that only short chains keep: fewer to look at.
  auto task = one_resonance();
  task.tolerance = 0.001 * units_per_mm;
  auto const with_guard = [](Candidate const& candidate) { return has_guard(candidate.chain); };
  auto const allowed = clean_candidates(task);
  CHECK(count_guards(allowed) > 0);
  CHECK(std::any_of(allowed.begin(), allowed.end(), [&](Candidate const& candidate) {
    return with_guard(candidate) && candidate.chain.filters.size() == 1;
  }));
  task.guards = Standing::excluded;
  auto const excluded = enumerate(task, Judge(task)).candidates;
  CHECK(count_guards(excluded) > 0);
  CHECK(std::none_of(excluded.begin(), excluded.end(), [&](Candidate const& candidate) {
    return candidate.is_clean && with_guard(candidate);
  }));
  task.guards = Standing::unknown;
  CHECK(count_guards(enumerate(task, Judge(task)).candidates) == 0);
  task.guards = Standing::allowed;
  task.kernels = Standing::excluded;
  auto const guarded = clean_candidates(task);
  CHECK(std::all_of(guarded.begin(), guarded.end(), [&](Candidate const& candidate) {
    return !candidate.chain.kernel || with_guard(candidate);
  }));
}

TEST_CASE("a guard of the lists that is long is judged to its last impulse") {
  // Half a period of 400 cycles; nothing happens between the impulses.
  Chain const chain{
      .kernel = design::KernelSpecification{
          .type = design::KernelType::vibration_guard, .order = 2, .frequency = {1.25}, .quality = 0}};
  auto const response = impulse_responses(std::span(&chain, 1), {1'000'000}).front();
  REQUIRE(response.taps.size() == 801);
  CHECK(response.taps[0] == Approx(0.25));
  CHECK(response.taps[400] == Approx(0.5));
  CHECK(response.taps[800] == Approx(0.25));
  CHECK(response.delay == Approx(400));
}

TEST_CASE("a guard becomes lines of a list, whatever other kernels the control has") {
  Chain const chain{
      .filters = {{.order = 1, .frequency = {60}}},
      .kernel = design::KernelSpecification{
          .type = design::KernelType::vibration_guard, .order = 4, .frequency = {48.5}, .quality = 0.05}};
  for (auto const family : {machine::KernelFamily::fir, machine::KernelFamily::hsc}) {
    auto const lines = list_lines(chain, family);
    REQUIRE(lines.size() == 10);
    CHECK(lines[0] == ListLine{"filter[0].enable", "1"});
    CHECK(std::vector<ListLine>(lines.begin() + 6, lines.end()) ==
          std::vector<ListLine>{{"vib_guard.active", "1"},
                                {"vib_guard.mode", "4"},
                                {"vib_guard.freq", "48.5"},
                                {"vib_guard.damping", "0.05"}});
    CHECK(filter_command(chain, family, 0.01) == "#VIB GUARD ON [AX_DEV=0.01]");
  }
}

}  // namespace axisc::tuning::guard_candidates_test
