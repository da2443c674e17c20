// How robust the Vibration Guard of a setting is against what is not known of the resonance.
#pragma once

#include "analysis/tuning/suggestion/task.hpp"
#include "design/kernels/vibration_guard.hpp"
#include "presentation/document.hpp"

#include <cstdint>
#include <optional>

namespace axisc {

/// Where a resonance lies, with twice its uncertainty, as seen from the interval of at most 5 %.
enum class Coverage : std::uint8_t {
  within,
  in_part,      ///< its frequency is within, what it may be reaches beyond
  outside,      ///< its frequency is not
  no_interval,  ///< more than 5 % at every frequency, or damped so much that an interval means little
};

struct GuardCoverage {
  design::KernelSpecification guard;
  std::optional<design::Robustness> interval;
  double residual = 0;          ///< at the guard's frequency and damping
  tuning::Resonance resonance;  ///< the nearest one of the task
  double uncertainty = 0;       ///< twice the resonance's, Hz; 0: as it was named
  Coverage coverage = Coverage::no_interval;
};

/// None for a chain without a guard.
[[nodiscard]] std::optional<GuardCoverage> guard_coverage(tuning::Chain const& chain,
                                                          tuning::Task const& task);

/// The interval and how the resonance lies to it, for people.
[[nodiscard]] presentation::Words coverage_words(GuardCoverage const& found);

/// The same for programs: an object `guard`.
[[nodiscard]] presentation::Section coverage_section(GuardCoverage const& found);

}  // namespace axisc
