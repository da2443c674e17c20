#include "analysis/tuning/position_control/stage_settings.hpp"

#include "design/filter_kinds.hpp"

#include <cmath>

namespace axisc::tuning {
namespace {

using machine::StageMode;

constexpr std::array modes = {StageMode::direct, StageMode::indirect, StageMode::set_point};
constexpr std::array shares = {0.9, 0.95, 1.0, 1.05, 1.1};
constexpr std::array qualities = {1.0, 2.0, 5.0, 10.0};
constexpr std::array dampings = {0.2, 0.4, 0.8};
constexpr std::uint32_t highest_order = 3;
/// P-AXIS-00751.
constexpr double highest_frequency = 500;

/// Cycles of dead time, of which 45° may come.
double dead_cycles(StageMode mode) {
  return mode == StageMode::direct ? 0 : mode == StageMode::indirect ? 2 : 1;
}

bool is_timely(double frequency, StageMode mode, design::CycleTime cycle_time) {
  constexpr double eighths = 8;
  return frequency * dead_cycles(mode) * eighths * cycle_time.seconds() <= 1;
}

}  // namespace

std::vector<machine::PositionControlStage> stages_for(double frequency, std::uint32_t index,
                                                      design::CycleTime cycle_time) {
  std::vector<machine::PositionControlStage> found;
  for (auto const mode : modes) {
    for (double const share : shares) {
      constexpr double tenths = 10;
      double const f0 = std::round(frequency * share * tenths) / tenths;
      if (f0 > highest_frequency || !is_timely(f0, mode, cycle_time)) continue;
      for (std::uint32_t order = 1; order <= highest_order; ++order) {
        for (double const quality : qualities) {
          machine::PositionControlStage stage{.index = index,
                                              .mode = mode,
                                              .oscillator = {},
                                              .filters = {{.type = design::FilterType::bandpass,
                                                           .prototype = design::Prototype::butterworth,
                                                           .order = order,
                                                           .frequency = {f0},
                                                           .quality = quality}},
                                              .weight_denominator = weight_denominator};
          if (!design::is_in_range(stage.filters.front(), cycle_time)) continue;
          if (mode == StageMode::direct) {
            found.push_back(stage);
            continue;
          }
          for (double const damping : dampings) {
            stage.oscillator = design::OscillatorSpecification{.frequency = {f0}, .damping = damping};
            found.push_back(stage);
          }
        }
      }
    }
  }
  return found;
}

bool are_apart(machine::PositionControlStage const& one, machine::PositionControlStage const& other) {
  auto const& a = one.filters.front();
  auto const& b = other.filters.front();
  return std::abs(a.frequency.value - b.frequency.value) >=
         a.frequency.value / (2 * a.quality) + b.frequency.value / (2 * b.quality);
}

}  // namespace axisc::tuning
