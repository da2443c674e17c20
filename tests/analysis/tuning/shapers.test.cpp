// What is suggested beside classic input shapers (Singer and Seering 1990; Singhose 1997), at an equal delay.
// The table is in docs/suggest.md.
#include "analysis/tuning/suggestion/choice.hpp"
#include "analysis/tuning/suggestion/list_lines.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/step_dynamics.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace axisc::tuning::shapers_test {
namespace {

struct Impulse {
  double time;  ///< in damped periods
  double share;
};

struct Shaper {
  std::string name;
  std::vector<Impulse> impulses;
};

/// For a damping ratio of 0.1, as is usual where it is not known; 5 % of the vibration are tolerated by EI
/// shapers.
std::vector<Shaper> shapers() {
  double const damping = 0.1;
  double const k = std::exp(-damping * std::numbers::pi / std::sqrt(1 - damping * damping));
  double const v = 0.05;
  double const x = std::cbrt(v * v * (std::sqrt(1 - v * v) + 1));
  double const edge = (3 * x * x + 2 * x + 3 * v * v) / (16 * x);
  auto const normalised = [](Shaper shaper) {
    double sum = 0;
    for (auto const& impulse : shaper.impulses) sum += impulse.share;
    for (auto& impulse : shaper.impulses) impulse.share /= sum;
    return shaper;
  };
  double const m = 1 - 1 / std::numbers::sqrt2;
  double const m2 = (std::numbers::sqrt2 - 1) * std::pow(k, 0.75);
  return {
      normalised({"ZV", {{0, 1}, {0.5, k}}}), normalised({"ZVD", {{0, 1}, {0.5, 2 * k}, {1, k * k}}}),
      normalised({"MZV", {{0, m}, {0.375, m2}, {0.75, m * std::pow(k, 1.5)}}}),
      normalised({"EI", {{0, (1 + v) / 4}, {0.5, (1 - v) / 2 * k}, {1, (1 + v) / 4 * k * k}}}),
      normalised({"2-hump EI",
                  {{0, edge}, {0.5, (0.5 - edge) * k}, {1, (0.5 - edge) * k * k}, {1.5, edge * k * k * k}}})};
}

/// As an interpolator would execute it: an impulse between two cycles is shared by them.
ImpulseResponse response_of(Shaper const& shaper, double period_cycles) {
  ImpulseResponse response{.taps = {}, .delay = 0};
  for (auto const& [time, share] : shaper.impulses) {
    double const place = time * period_cycles;
    auto const before = static_cast<std::size_t>(place);
    response.taps.resize(std::max(response.taps.size(), before + 2));
    double const part = place - std::floor(place);
    response.taps[before] += share * (1 - part);
    response.taps[before + 1] += share * part;
    response.delay += share * place;
  }
  return response;
}

}  // namespace

TEST_CASE("the page on suggestions compares with classic shapers at an equal delay") {
  constexpr double units_per_mm = 1e4;
  Task const task{.cycle_time = {1'000'000},
                  .resonances = {{.frequency = 48, .damping = 0.03}},
                  .velocity = 4000.0 / 60 * units_per_mm * 1e-3,
                  .dynamics = test::step_dynamics(3000 * units_per_mm * 1e-6),
                  .tolerance = 0.1 * units_per_mm,
                  .radius = 10 * units_per_mm};
  Judge const judge(task);
  auto enumeration = enumerate(task, judge);
  auto const corner_um = [&](Figures const& figures) { return figures.corner * task.velocity / 10; };
  std::string table =
      "| shaper | delay [ms] | remaining vibration [%] | corner [µm] | filters of the control | delay [ms] | "
      "remaining vibration [%] | corner [µm] |\n|---|---|---|---|---|---|---|---|\n";
  double const period = 1000 / (48 * std::sqrt(1 - 0.1 * 0.1));
  for (auto const& shaper : shapers()) {
    auto const figures = judge.figures(response_of(shaper, period));
    Candidate const* best = nullptr;
    for (auto& candidate : enumeration.candidates) {
      // Half a cycle is what a whole number of cycles costs.
      if (!candidate.is_clean || candidate.figures.delay > figures.delay + 0.5) continue;
      // What is looked at first is a bound, then an estimate, then the figure itself.
      while (!candidate.is_settled &&
             (best == nullptr || candidate.figures.vibration < best->figures.vibration)) {
        refine(candidate, judge);
      }
      if (!candidate.is_settled) continue;
      if (best == nullptr || candidate.figures.vibration < best->figures.vibration) best = &candidate;
    }
    REQUIRE(best != nullptr);
    table += fmt::format("| {} | {:.1f} | {:.1f} | {:.0f} | {} | {:.1f} | {:.1f} | {:.0f} |\n", shaper.name,
                         figures.delay, figures.vibration * 100, corner_um(figures),
                         short_name(best->chain, Language::english), best->figures.delay,
                         best->figures.vibration * 100, corner_um(best->figures));
  }
  auto page = test::read_source_file("docs/suggest.md");
  auto const begin = page.find("| shaper |");
  REQUIRE(begin != std::string::npos);
  auto const end = page.find("\n\n", begin);
  REQUIRE(end != std::string::npos);
  page.replace(begin, end + 1 - begin, table);
  test::check_golden("docs/suggest.md", page);
}

}  // namespace axisc::tuning::shapers_test
