// The Vibration Guards of the axes that a picture shows.
#pragma once

#include "axisc/answers/figures/plots.hpp"
#include "design/kernels/vibration_guard.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// A guard of one state of the machine, with its figures.
struct ShownGuard {
  design::KernelSpecification specification;
  design::KernelDesign design;
  design::CycleTime cycle_time;
  std::optional<design::Robustness> interval;
  double residual = 0;  ///< at its own frequency and damping

  friend bool operator==(ShownGuard const& one, ShownGuard const& other) {
    return one.specification == other.specification;
  }
};

/// What the lists, or one command, give axes that have the same guard: now, and in an earlier state.
struct GuardStates {
  std::string axes;     ///< "X, Y"
  std::string command;  ///< "#VIB GUARD ON [MODE=4]"; empty: as the lists have it
  std::optional<ShownGuard> now, before;
};

/// Guards of the lists first, then those that commands make different.
[[nodiscard]] std::vector<GuardStates> guard_states(PlotSubject const& subject);

}  // namespace axisc
