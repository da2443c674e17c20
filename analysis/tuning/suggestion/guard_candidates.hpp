// Vibration Guard against the resonances of a task: modes 1 to 4, set to 0.85 to 1.15 of each resonance in
// steps of 1 %, for the damping ratio that is known and for 0.02, 0.05 and 0.1.
#pragma once

#include "analysis/tuning/suggestion/impulse_response.hpp"
#include "analysis/tuning/suggestion/task.hpp"

#include <vector>

namespace axisc::tuning {

/// As the control reads their parameters, each once. Guards whose last impulse comes later than
/// design::longest_usual_guard are left out: lists have a finding about them (AX3027).
[[nodiscard]] std::vector<Chain> guard_candidates(Task const& task);

/// More than design::usual_residual is left at the guard's own frequency: lists have a finding about it
/// (AX3028). `response` is that of the guard alone.
[[nodiscard]] bool is_coarse(design::KernelSpecification const& guard, ImpulseResponse const& response,
                             design::CycleTime cycle_time);

}  // namespace axisc::tuning
