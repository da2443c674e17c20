// The words by which settings name how a control plans a path where its manuals leave it open.
#pragma once

#include "configuration/machine/path_dynamics.hpp"

#include <array>
#include <string_view>

namespace axisc::machine {

// By number; the first of each is the default.
inline constexpr std::array<std::string_view, 2> projection_words{"weakest-jerk", "longest-ramp"};
inline constexpr std::array<std::string_view, 2> border_words{"rest", "continuous"};
inline constexpr std::array<std::string_view, 3> sine_words{"ramps", "whole-change", "same-peak-jerk"};
inline constexpr std::array<std::string_view, 2> circle_words{"shared", "full"};
inline constexpr std::array<std::string_view, 3> corner_words{"per-cycle", "up-only", "down-only"};
inline constexpr std::array<std::string_view, 2> transition_words{"r-follows-a", "a-follows-r"};
inline constexpr std::array<std::string_view, 2> cycle_words{"continuous", "whole"};
inline constexpr std::array<std::string_view, 2> hsc_words{"stretches", "trapez"};

/// Calls `visit(key, words, number)` for each reading: the key of settings, its words, the number of its
/// word.
template <typename Visit>
void for_each_reading(MotionReadings const& readings, Visit visit) {
  auto const number = [](auto reading) { return static_cast<std::size_t>(reading); };
  visit("projection", projection_words, number(readings.projection));
  visit("borders", border_words, number(readings.borders));
  visit("sine", sine_words, number(readings.sine));
  visit("circle", circle_words, number(readings.circle));
  visit("corner", corner_words, number(readings.corner));
  visit("weights", transition_words, number(readings.weights));
  visit("cycles", cycle_words, number(readings.cycles));
  visit("hsc", hsc_words, number(readings.hsc));
}

}  // namespace axisc::machine
