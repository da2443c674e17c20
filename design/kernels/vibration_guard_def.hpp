// Impulses of Vibration Guard and their taps, in one number type.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "design/kernels/vibration_guard.hpp"
#include "design/pi_def.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::design {

/// √(1 - D²)
template <typename Number>
[[nodiscard]] Number damped_share(Number const& D) {
  using std::sqrt;
  return sqrt(Number((1 - D) * (1 + D)));
}

/// K = exp(-π D/√(1 - D²))
template <typename Number>
[[nodiscard]] Number half_period_decay(Number const& D) {
  using std::exp;
  return exp(Number(-pi<Number>() * D / damped_share(D)));
}

/// h/T = 1/(2 f T √(1 - D²))
template <typename Number>
[[nodiscard]] Number half_period_cycles(KernelSpecification const& guard, CycleTime cycle_time) {
  Number const half_period = 1 / (2 * cycle_time.periods_in<Number>(guard.frequency));
  bool const is_undamped = applied_reading(guard) == KernelReading::guard_undamped_spacing;
  return is_undamped ? half_period : Number(half_period / damped_share(Number(guard.quality)));
}

/// The amplitudes of the impulses at 0, h, 2h, 3h.
template <typename Number>
[[nodiscard]] std::vector<Number> guard_amplitudes(KernelSpecification const& guard) {
  if (applied_reading(guard) == KernelReading::guard_quarters) {
    return {Number(1) / 4, Number(1) / 2, Number(1) / 4};
  }
  Number const K = half_period_decay(Number(guard.quality));
  if (guard.order == symmetrical_guard) {
    Number const scale = 1 / ((1 + K) * (1 + K));
    return {K * scale, (1 + K * K) * scale, K * scale};
  }
  // One pair after the other: each convolves with 1/(1 + K), K/(1 + K).
  std::vector<Number> amplitudes{Number(1)};
  for (std::uint32_t pair = 0; pair < guard.order; ++pair) {
    amplitudes.push_back(Number(0));
    for (std::size_t i = amplitudes.size() - 1; i > 0; --i) {
      amplitudes[i] = (amplitudes[i] + K * amplitudes[i - 1]) / (1 + K);
    }
    amplitudes[0] = amplitudes[0] / (1 + K);
  }
  return amplitudes;
}

/// Where an impulse at `cycles` goes: on `cycle`, and the share `next` of it on the one after.
template <typename Number>
struct GuardPlace {
  std::size_t cycle = 0;
  Number next{0};
};

/// Which cycle it is, double precision decides everywhere; so near to a whole number it counts as it.
inline constexpr double on_a_cycle = 1e-9;

template <typename Number>
[[nodiscard]] GuardPlace<Number> guard_place(KernelReading reading, double cycles, Number const& exact) {
  double const nearest = std::floor(cycles + 0.5);
  if (reading == KernelReading::guard_rounded || std::abs(cycles - nearest) <= on_a_cycle) {
    return {static_cast<std::size_t>(nearest)};
  }
  if (reading == KernelReading::guard_rounded_up) return {static_cast<std::size_t>(std::ceil(cycles))};
  auto const below = static_cast<std::uint32_t>(cycles);
  return {below, Number(exact - below)};
}

/// Taps a_0 at 0, a_1 at q and a_2 at q + 1, together 1, with a zero on the oscillation:
///     a_0 + a_1 w^q + a_2 w^(q+1) = 0,  w = e^((D + j √(1 - D²)) 2π f T),  q = ⌊h/T⌋
template <typename Number>
[[nodiscard]] std::vector<Number> zero_placed_pair(KernelSpecification const& guard, CycleTime cycle_time) {
  using std::cos;
  using std::exp;
  using std::sin;
  Number const angle = 2 * pi<Number>() * cycle_time.periods_in<Number>(guard.frequency);
  Number const growth = angle * Number(guard.quality);
  Number const turn = angle * damped_share(Number(guard.quality));
  auto const q = static_cast<std::uint32_t>(half_period_cycles<double>(guard, cycle_time));
  // The imaginary part gives a_2/a_1, the real one a_0/a_1.
  Number const wide = exp(Number(growth * q));
  Number const wider = exp(Number(growth * (q + 1)));
  Number const a_2 = -wide * sin(Number(turn * q)) / (wider * sin(Number(turn * (q + 1))));
  Number const a_0 = -wide * cos(Number(turn * q)) - a_2 * wider * cos(Number(turn * (q + 1)));
  Number const sum = a_0 + 1 + a_2;
  std::vector<Number> taps(q + 2, Number(0));
  taps[0] = a_0 / sum;
  taps[q] += 1 / sum;
  taps[q + 1] = a_2 / sum;
  return taps;
}

template <typename Number>
[[nodiscard]] std::vector<Number> convolved(std::vector<Number> const& a, std::vector<Number> const& b) {
  std::vector<Number> product(a.size() + b.size() - 1, Number(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0) continue;
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] += a[i] * b[k];
  }
  return product;
}

/// Mode 4 with its middle on cycle c = ⌈h/T⌉.
template <typename Number>
[[nodiscard]] std::vector<Number> centred_taps(KernelSpecification const& guard, CycleTime cycle_time) {
  std::vector<Number> const amplitudes = guard_amplitudes<Number>(guard);
  auto const h = half_period_cycles<double>(guard, cycle_time);
  auto const c = static_cast<std::size_t>(std::ceil(h - on_a_cycle));
  auto const place = guard_place(KernelReading::documented, h, half_period_cycles<Number>(guard, cycle_time));
  std::vector<Number> taps(2 * c + 1, Number(0));
  taps[c] = amplitudes[1];
  for (std::size_t side : {c - place.cycle, c + place.cycle}) taps[side] += amplitudes[0] * (1 - place.next);
  if (place.next != 0) {
    for (std::size_t side : {c - place.cycle - 1, c + place.cycle + 1}) {
      taps[side] += amplitudes[0] * place.next;
    }
  }
  return taps;
}

[[nodiscard]] inline bool is_symmetrical_guard(KernelSpecification const& guard) {
  KernelReading const reading = applied_reading(guard);
  return guard.order == symmetrical_guard && reading != KernelReading::guard_rounded &&
         reading != KernelReading::guard_rounded_up && reading != KernelReading::guard_uncentred;
}

/// The causal taps b_0, b_1, … of a guard, sum 1; those of mode 4 are symmetrical unless a reading says
/// otherwise.
template <typename Number>
[[nodiscard]] std::vector<Number> guard_taps(KernelSpecification const& guard, CycleTime cycle_time) {
  KernelReading const reading = applied_reading(guard);
  if (reading == KernelReading::guard_zero_placed) {
    auto const pair = zero_placed_pair<Number>(guard, cycle_time);
    if (guard.order == symmetrical_guard) {
      return convolved(pair, std::vector<Number>(pair.rbegin(), pair.rend()));
    }
    auto taps = pair;
    for (std::uint32_t more = 1; more < guard.order; ++more) taps = convolved(taps, pair);
    return taps;
  }
  if (is_symmetrical_guard(guard)) return centred_taps<Number>(guard, cycle_time);
  std::vector<Number> const amplitudes = guard_amplitudes<Number>(guard);
  auto const h = half_period_cycles<double>(guard, cycle_time);
  auto const exact_h = half_period_cycles<Number>(guard, cycle_time);
  std::vector<Number> taps;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    auto const place =
        guard_place(reading, h * static_cast<double>(i), Number(exact_h * static_cast<unsigned>(i)));
    taps.resize(std::max(taps.size(), place.cycle + (place.next != 0 ? 2 : 1)), Number(0));
    taps[place.cycle] += amplitudes[i] * (1 - place.next);
    if (place.next != 0) taps[place.cycle + 1] += amplitudes[i] * place.next;
  }
  return taps;
}

}  // namespace axisc::design
