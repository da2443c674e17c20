// How a setpoint chain answers a change of velocity: all that a contour prediction needs to know about it.
//
// The runtime executes a ramp  x[n] = max(0, n)  of one unit per cycle; its answer r[n] ends up D cycles
// behind. By superposition an axis whose velocity changes from v0 to v1 units per cycle at n = 0 passes
//     y[n] = v0 (n - D - r[n]) + v1 r[n].
// What is left of the corner after the delay is  R(τ) = r[D + τ] - max(0, τ),  for a symmetric kernel
//     R(0) = Σ_{k=1..h} k b_k,  R(τ) = 0 for |τ| ≥ h.
#pragma once

#include "analysis/motion/group_runtime.hpp"

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace axisc::motion {

struct ChainAnswer {
  std::vector<double> ramp;  ///< r[0], r[1], …, until the answer has settled
  double delay = 0;          ///< D in cycles
  double reach =
      0;  ///< smallest distance in cycles from which on R(τ) is negligible; h for a symmetric kernel
  double corner = 0;  ///< R(0) in cycles

  /// r at any time in cycles. Linear between two cycles, which is not an approximation: the answer to a ramp
  /// that begins between two cycles is  (1 - φ) r[n] + φ r[n-1].
  [[nodiscard]] double ramp_at(double cycles) const;
  /// The answer to an impulse is the second difference of the ramp's:  b[k] = r[k+1] - 2 r[k] + r[k-1].
  [[nodiscard]] double tap(std::size_t k) const {
    return ramp[k + 1] - 2 * ramp[k] + (k > 0 ? ramp[k - 1] : 0.0);
  }
  [[nodiscard]] std::size_t tap_count() const { return ramp.size() - 1; }
  /// R(τ).
  [[nodiscard]] double remainder(double tau) const;
  /// The chain does nothing but delay by whole cycles.
  [[nodiscard]] bool only_delays() const { return reach == 0; }
};

/// Why there is no answer.
struct NoAnswer {
  std::size_t axis =
      0;  ///< of the path: it does not follow a ramp, because its chain blocks the constant part
};

/// From the answer r to the ramp, long enough to have settled; none where it does not follow the ramp.
[[nodiscard]] std::optional<ChainAnswer> chain_answer(std::vector<double> ramp);

/// Executes the chains of all axes as they are switched now; afterwards every axis rests at 0. Cost: some
/// hundred cycles for kernels, at most longest_answer cycles.
[[nodiscard]] std::variant<std::vector<ChainAnswer>, NoAnswer> chain_answers(GroupRuntime& runtime);

inline constexpr std::size_t longest_answer = std::size_t{1} << 17U;

}  // namespace axisc::motion
