// The parameters of an axis' Vibration Guard, seen together: vib_guard.
#pragma once

#include "configuration/machine/filter_command.hpp"
#include "design/kernels/kernel_design.hpp"
#include "validator/values/effective_values.hpp"

#include <optional>

namespace axisc::validator {

/// References stay valid while the EffectiveValues live.
struct GuardView {
  EffectiveValue const& active;
  EffectiveValue const& mode;
  EffectiveValue const& frequency;
  EffectiveValue const& damping;
  design::Readings readings;  ///< of the values

  explicit GuardView(EffectiveValues const& values);

  [[nodiscard]] bool is_active() const { return active.is_on(); }
  /// The guard of the lists' values, active or not; none if one of them is out of its range, and for a
  /// damping of 1, with which there is no oscillation. It may be longer than a runtime takes.
  [[nodiscard]] std::optional<design::KernelSpecification> specification(design::CycleTime cycle_time) const;
  /// The place of a finding about `wanted`, as in FilterView.
  [[nodiscard]] EffectiveValue const& anchor(EffectiveValue const& wanted) const;
};

/// The guard that a command makes of the lists' one: none where its damping is 1.
[[nodiscard]] std::optional<design::KernelSpecification> guard_after(
    design::KernelSpecification const& listed, machine::FilterParameters const& parameters);

/// A runtime takes it: its last impulse is within design::longest_guard cycles.
[[nodiscard]] bool can_be_compiled(design::KernelSpecification const& guard, design::CycleTime cycle_time);

}  // namespace axisc::validator
