// Vibration Guard: the input shapers of `vib_guard.*` and #VIB GUARD.
//
// The manuals name modes, effects and guide values, but no formula; these shapers are the ones whose bands of
// robustness contain the vendor's guide values (a reading). For a natural frequency f with damping ratio D
//
//   K = exp(-π D/√(1 - D²))        by how much half a period damps
//   h = 1/(2 f √(1 - D²))          half a damped period
//   modes n = 1, 2, 3              C(n, i) Kⁱ/(1 + K)ⁿ at i h, i = 0..n: ZV, ZVD, ZVDD (Singer, Seering 1990)
//   mode 4                         K : 1 + K² : K over (1 + K)² at 0, h, 2h: ZV by itself reversed
//
// An impulse between two cycles is split linearly among them. Mode 4 is centred on cycle c = ⌈h/T⌉, so that
// the kernel stays symmetrical. All taps are positive: no overshoot, and a peak gain of 1.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace axisc::design {

inline constexpr std::uint32_t symmetrical_guard = 4;  ///< the mode
inline constexpr std::uint32_t guard_modes = 4;

/// An impulse of the shaper, before it is placed on cycles.
struct Impulse {
  Microseconds time;
  double amplitude = 0;  ///< of all together 1
};

/// The impulses that a guard's specification asks for, by rising time. Expects type vibration_guard within
/// its ranges.
[[nodiscard]] std::vector<Impulse> guard_impulses(KernelSpecification const& guard);

/// The time of the last impulse in cycles; infinite for D = 1, with which there is no oscillation.
[[nodiscard]] double guard_length(KernelSpecification const& guard, CycleTime cycle_time);

/// The least frequency whose last impulse comes within `cycles`, with mode and damping as they are.
[[nodiscard]] Hertz lowest_guard_frequency(KernelSpecification const& guard, CycleTime cycle_time,
                                           double cycles);

/// What a setpoint that comes to rest leaves of an oscillation at frequency fa with damping ratio Da,
/// relative to the same setpoint without the kernel, counted from the last tap:
///     V = e^(-σN) |Σ b_k e^((σ + jω) k)|,  σ = 2π fa T Da,  ω = 2π fa T √(1 - Da²)
/// Da = 0 gives the magnitude of the response. Cost: about 20 ns per tap.
[[nodiscard]] double residual_vibration(KernelDesign const& kernel, Hertz actual, double damping,
                                        CycleTime cycle_time);

/// How far the actual frequency may be from the configured one: V ≤ 5 % for every actual frequency whose
/// ratio configured/actual is within 1 + lowest .. 1 + highest.
struct Robustness {
  double lowest = 0;   ///< at most 0
  double highest = 0;  ///< at least 0
  Hertz from;          ///< configured/(1 + highest)
  Hertz to;            ///< configured/(1 + lowest)
};

inline constexpr double permitted_residual = 0.05;

// What passes without a word: the control's own limits are not documented.
/// Cycles until the last impulse, the limit of FIR filters.
inline constexpr double longest_usual_guard = longest_kernel_order;
/// V at the configured frequency and damping.
inline constexpr double usual_residual = 0.02;

/// V at the configured frequency and damping.
[[nodiscard]] double residual_at_design(KernelDesign const& kernel, KernelSpecification const& guard,
                                        CycleTime cycle_time);

/// With the configured damping; none where more than 5 % are left at the configured frequency, and above the
/// damping from which a band means little (0.3). Searched between half and twice the frequency. Cost: up to
/// 1 ms.
[[nodiscard]] std::optional<Robustness> robustness(KernelDesign const& kernel,
                                                   KernelSpecification const& guard, CycleTime cycle_time);

/// The vendor's guide values of a mode at a damping of 0.1: lowest and highest of Robustness.
[[nodiscard]] std::pair<double, double> guide_values(std::uint32_t mode);

}  // namespace axisc::design
