#include "design/kernels/vibration_guard.hpp"

#include "design/kernels/vibration_guard_def.hpp"

#include <array>
#include <complex>
#include <numbers>

#include <boost/math/tools/toms748_solve.hpp>

namespace axisc::design {
namespace {

/// Up to here a shaper is told apart by its band; a plant damped more leaves little of any oscillation.
constexpr double most_damping_with_band = 0.3;

}  // namespace

std::vector<Impulse> guard_impulses(KernelSpecification const& guard) {
  // Of a cycle time of 1 µs the number of cycles is the time itself.
  double const half_period = half_period_cycles<double>(guard, CycleTime{1'000});
  std::vector<Impulse> impulses;
  for (double const amplitude : guard_amplitudes<double>(guard)) {
    impulses.push_back({{half_period * static_cast<double>(impulses.size())}, amplitude});
  }
  return impulses;
}

double guard_length(KernelSpecification const& guard, CycleTime cycle_time) {
  double const halves = guard.order == symmetrical_guard ? 2 : guard.order;
  return halves * half_period_cycles<double>(guard, as_read(cycle_time, guard.cycle_time));
}

Hertz lowest_guard_frequency(KernelSpecification const& guard, CycleTime cycle_time, double cycles) {
  return {guard.frequency.value * guard_length(guard, cycle_time) / cycles};
}

double residual_vibration(KernelDesign const& kernel, Hertz actual, double damping, CycleTime cycle_time) {
  double const angle = 2 * std::numbers::pi * cycle_time.periods_in<double>(actual);
  std::complex<double> const step(angle * damping, angle * damped_share(damping));
  auto const N = static_cast<double>(kernel.taps.size() - 1);
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < kernel.taps.size(); ++k) {
    // Every term with its part of e^(-σN): none of them overflows.
    if (kernel.taps[k] == 0) continue;
    auto const cycle = static_cast<double>(k);
    sum += kernel.taps[k] * std::polar(std::exp(step.real() * (cycle - N)), step.imag() * cycle);
  }
  return std::abs(sum);
}

double residual_at_design(KernelDesign const& kernel, KernelSpecification const& guard,
                          CycleTime cycle_time) {
  return residual_vibration(kernel, guard.frequency, guard.quality, cycle_time);
}

std::optional<Robustness> robustness(KernelDesign const& kernel, KernelSpecification const& guard,
                                     CycleTime cycle_time) {
  if (guard.quality >= most_damping_with_band) return std::nullopt;
  // V over the ratio configured/actual, above and below what is permitted.
  auto const excess = [&](double ratio) {
    Hertz const actual{guard.frequency.value / ratio};
    return residual_vibration(kernel, actual, guard.quality, cycle_time) - permitted_residual;
  };
  double const at_design = excess(1);
  if (at_design > 0) return std::nullopt;
  auto const edge = [&](double direction) {
    constexpr double step = 0.002;
    constexpr double lowest = 0.5, highest = 2;
    double inside = 1, value_inside = at_design;
    for (double ratio = 1 + direction * step; ratio >= lowest && ratio <= highest;
         ratio += direction * step) {
      double const value = excess(ratio);
      if (value > 0) {
        std::uintmax_t iterations = 100;
        boost::math::tools::eps_tolerance<double> const tolerance(50);
        bool const rises = direction > 0;
        auto const bracket = boost::math::tools::toms748_solve(
            excess, rises ? inside : ratio, rises ? ratio : inside, rises ? value_inside : value,
            rises ? value : value_inside, tolerance, iterations);
        return (bracket.first + bracket.second) / 2;
      }
      inside = ratio;
      value_inside = value;
    }
    return inside;
  };
  double const low = edge(-1), high = edge(1);
  return Robustness{.lowest = low - 1,
                    .highest = high - 1,
                    .from = {guard.frequency.value / high},
                    .to = {guard.frequency.value / low}};
}

std::pair<double, double> guide_values(std::uint32_t mode) {
  constexpr std::array<std::pair<double, double>, guard_modes> values{
      {{-0.03, 0.03}, {-0.13, 0.19}, {-0.20, 0.33}, {-0.10, 0.13}}};
  return values[mode - 1];
}

}  // namespace axisc::design
