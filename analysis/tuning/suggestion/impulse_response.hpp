// The runtime's answer to an impulse: all that is needed to judge a linear chain.
#pragma once

#include "analysis/tuning/suggestion/task.hpp"

#include <span>
#include <vector>

namespace axisc::tuning {

struct ImpulseResponse {
  std::vector<double> taps = {1.0};  ///< b[0], b[1], …; what follows adds up to less than 1e-9
  double delay = 0;                  ///< Σ n b[n], the group delay at 0 Hz in cycles

  /// The chain blocks the constant part: its setpoint never arrives.
  [[nodiscard]] bool blocks_constant() const;
};

/// Compiles an axis for each chain and executes them together; every kernel is on.
[[nodiscard]] std::vector<ImpulseResponse> impulse_responses(std::span<Chain const> chains,
                                                             design::CycleTime cycle_time);

[[nodiscard]] ImpulseResponse in_series(ImpulseResponse const& first, ImpulseResponse const& second);

}  // namespace axisc::tuning
