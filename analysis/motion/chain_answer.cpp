#include "analysis/motion/chain_answer.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// A ramp has settled when its answer grew by one unit per cycle, within this, for as long as a kernel may
/// be.
constexpr double settled_within = 1e-11;
constexpr std::size_t settled_cycles = 256;
/// For a ramp of one unit per cycle: less than a picometre at any feed.
constexpr double negligible = 1e-8;

/// Answers of all axes, until the last of them follows.
std::vector<std::vector<double>> execute_ramps(GroupRuntime& runtime) {
  std::size_t const axes = runtime.axis_count();
  std::vector<std::vector<double>> answers(axes);
  static_cast<void>(runtime.reset({}));
  Point in{};
  Point out{};
  Point before{};
  std::vector<std::size_t> steady(axes, 0);
  for (std::size_t n = 0; n < longest_answer; ++n) {
    in.fill(static_cast<double>(n));
    static_cast<void>(runtime.step(in, out));
    for (std::size_t i = 0; i < axes; ++i) {
      answers[i].push_back(out[i]);
      steady[i] = std::abs(out[i] - before[i] - 1) <= settled_within ? steady[i] + 1 : 0;
    }
    before = out;
    if (*std::min_element(steady.begin(), steady.end()) >= settled_cycles) break;
  }
  static_cast<void>(runtime.reset({}));
  return answers;
}

double whole_where_close(double x) {
  double const whole = std::round(x);
  return std::abs(x - whole) < 1e-7 ? whole : x;
}

/// Smallest τ from which on nothing is left, on either side.
double reach_of(ChainAnswer const& answer) {
  double const last = static_cast<double>(answer.ramp.size()) - 1 - answer.delay;
  double reach = std::max(answer.delay, last);
  while (reach >= 0 && std::abs(answer.remainder(reach)) <= negligible &&
         std::abs(answer.remainder(-reach)) <= negligible) {
    reach -= 1;
  }
  return std::max(0.0, std::floor(reach) + 1);
}

}  // namespace

double ChainAnswer::ramp_at(double cycles) const {
  if (cycles <= 0) return 0;
  double const last = static_cast<double>(ramp.size()) - 1;
  if (cycles >= last) return cycles - delay;
  auto const before = static_cast<std::size_t>(cycles);
  double const share = cycles - static_cast<double>(before);
  return ramp[before] + share * (ramp[before + 1] - ramp[before]);
}

double ChainAnswer::remainder(double tau) const {
  return ramp_at(delay + tau) - std::max(0.0, tau);
}

std::optional<ChainAnswer> chain_answer(std::vector<double> ramp) {
  double const n = static_cast<double>(ramp.size()) - 1;
  double const slope = ramp.back() - ramp[ramp.size() - 2];
  if (std::abs(slope - 1) > 1e-6) return std::nullopt;
  ChainAnswer answer;
  answer.delay = whole_where_close(n - ramp.back());
  answer.ramp = std::move(ramp);
  answer.corner = answer.remainder(0);
  answer.reach = reach_of(answer);
  if (std::abs(answer.corner) <= negligible && answer.reach <= 1) {
    answer.reach = answer.corner = 0;
  }
  return answer;
}

std::variant<std::vector<ChainAnswer>, NoAnswer> chain_answers(GroupRuntime& runtime) {
  auto ramps = execute_ramps(runtime);
  std::vector<ChainAnswer> answers;
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    auto answer = chain_answer(std::move(ramps[i]));
    if (!answer) return NoAnswer{.axis = i};
    answers.push_back(*std::move(answer));
  }
  return answers;
}

}  // namespace axisc::motion
