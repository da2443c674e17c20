// The parameters of Improved Position Control, seen together, in both spellings of a stage: `filter.order`
// with `filter.damping`, and from V3.1.3132.0 `filter[k].order` with `osc_damping`.
#pragma once

#include "configuration/machine/machine.hpp"
#include "validator/values/effective_values.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::validator {

inline constexpr std::uint32_t position_control_stages = 3;
inline constexpr std::uint32_t filters_per_stage = 2;

enum class StageFilterType : std::uint8_t { none, bandpass, allpass };

/// References stay valid while the EffectiveValues live.
struct StageFilterView {
  EffectiveValue const* type;       ///< null in the older spelling: always a band-pass
  EffectiveValue const* prototype;  ///< null in the older spelling, of the band-pass
  EffectiveValue const& order;
  EffectiveValue const& frequency;
  EffectiveValue const& quality;  ///< q_factor, for the band-pass
  StageFilterType kind;
};

struct StageView {
  std::uint32_t index;
  EffectiveValue const& mode;
  EffectiveValue const& weight_numerator;
  EffectiveValue const& weight_denominator;
  EffectiveValue const& older_damping;                   ///< filter.damping
  EffectiveValue const& newer_damping;                   ///< osc_damping
  StageFilterView older;                                 ///< filter.x
  std::array<StageFilterView, filters_per_stage> newer;  ///< filter[k].x

  StageView(EffectiveValues const& values, std::uint32_t index);

  /// none for NOT_ACTIVE, and if the mode cannot be used.
  [[nodiscard]] std::optional<machine::StageMode> active_mode() const;
  /// INDIRECT and SET_POINT simulate the vibration with an oscillator.
  [[nodiscard]] bool simulates() const;
  /// A list configures filter[k].x of this stage.
  [[nodiscard]] bool uses_newer_filters() const;
  /// The filters in series, without NO_FILTER.
  [[nodiscard]] std::vector<StageFilterView> filters() const;
  /// The first band-pass: its frequency is the one that the stage damps.
  [[nodiscard]] std::optional<StageFilterView> bandpass() const;
  /// osc_damping where a list configures it, or the filters are in the newer spelling; else filter.damping.
  [[nodiscard]] EffectiveValue const& damping() const;
};

struct PositionControlView {
  EffectiveValue const& enable;
  EffectiveValue const& limit;  ///< v_add_max_fact
  /// All stages; none if the function is off by default and no list sets `enable` or a parameter of a stage.
  std::vector<StageView> stages;

  explicit PositionControlView(EffectiveValues const& values);

  [[nodiscard]] bool enabled() const { return enable.is_on(); }
  /// Stages that work: the function is enabled and their mode is not NOT_ACTIVE.
  [[nodiscard]] std::vector<StageView> active_stages() const;
};

}  // namespace axisc::validator
