// Every chain that the control could have for a task, estimated. There are few enough to look at all of them.
//
// Kernels: moving average and Gaussian (quality 1, 0.8, 0.6) of every half width, windowed sinc of every half
// width with cut-offs from a third to the whole of each resonance, HSC mean, and NoVib on each resonance
// and 5 or 10 % away from it.
// Standard filters: critically damped low-passes of order 1 to 6 with cut-offs from 0.15 to 2 times the
// lowest resonance, and band-stops on each resonance, with every prototype, orders 1 to 3 and qualities from
// 1 to 10.
// Vibration Guard: see guard_candidates.hpp.
// Cascades: two low-passes; band-stops on several resonances; a low-pass or band-stops before a moving
// average or a Gaussian kernel (of half widths from 32 on every second, from 64 on every third), or before a
// Vibration Guard.
//
// Chains that deviate on the circle by more than the tolerance, or delay by more than longest_delay, are
// counted and left out.
#pragma once

#include "analysis/tuning/suggestion/judgement.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace axisc::tuning {

/// Beyond this a chain overshoots noticeably (AX6004).
inline constexpr double largest_overshoot = 0.01;
/// Beyond this operators notice the delay (AX6007); s.
inline constexpr double longest_delay = 0.1;

struct Candidate {
  Chain chain;
  Figures figures;  ///< Judge::bound(), Judge::estimate(), once settled Judge::figures()
  /// Lists may set it without a finding: no band-stop, no overshoot, a kernel that the control has and that
  /// no program excludes.
  bool is_clean = true;
  bool is_estimated = true;  ///< false: the figures are those of Judge::bound()
  bool is_settled = false;
  std::shared_ptr<ImpulseResponse const> first = {},
                                         second = {};  ///< responses in series; the second may be null
};

/// Does nothing where it is settled.
void settle(Candidate& candidate, Judge const& judge);
/// From a bound to an estimate, from an estimate to figures.
void refine(Candidate& candidate, Judge const& judge);

struct Enumeration {
  std::vector<Candidate> candidates;  ///< that keep the tolerance on the circle
  std::size_t looked_at = 0;          ///< including those that do not
};

/// In an order of its own, the same on every host; none is settled. `judge`: of the task.
[[nodiscard]] Enumeration enumerate(Task const& task, Judge const& judge);

}  // namespace axisc::tuning
