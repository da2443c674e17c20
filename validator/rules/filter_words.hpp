// How the rules about filters name things: parameters, values with units, the control's reactions.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/engine/rule.hpp"
#include "validator/views/filter_view.hpp"

#include <string>
#include <string_view>

namespace axisc::validator::checks {

/// "filter[0]", "lr_param.add_interface.filter[0]".
[[nodiscard]] std::string filter_name(FilterView const& filter);
/// The symbol of a value, also if the list has its number or the internal default applies: "BUTTERWORTH".
[[nodiscard]] std::string symbol_word(EffectiveValue const& value);

/// A value for display: six significant digits, integers in full.
[[nodiscard]] Wording number(double value);
/// "10.9" for a share of 0.109: one decimal, two significant digits below a tenth of a percent.
[[nodiscard]] Wording percent(double share);
/// "1000 µs".
[[nodiscard]] Wording microseconds(double value);
/// "12 ms".
[[nodiscard]] Wording milliseconds(double value);

/// A time in microseconds: "12000 µs (12 ms) are 12 cycles of 1000 µs".
[[nodiscard]] Message time_in_cycles(double time, design::CycleTime cycle_time);

/// Sets the reaction of the control; `value` is what it continues with.
void react(Finding& finding, Message reaction, std::string value = {});
/// Sets the reaction with `control`, those of the row's message numbers that fit.
void react(Finding& finding, std::string_view control, Message reaction, std::string value = {});

/// Adds which default applies if no list sets `value`.
void note_default(Finding& finding, EffectiveValue const& value);

/// Points to a type if a list sets it.
void relate_set_type(Finding& finding, EffectiveValue const& type);
/// Points to the type if a list sets it; else notes which type applies by default.
void relate_type(Finding& finding, FilterView const& filter);

/// Message numbers of the control for a time constant that it rejects: on a path axis, on a spindle, in the
/// position controller.
inline constexpr std::string_view path_refuses_time = "50663";
inline constexpr std::string_view spindle_refuses_time = "60311";
inline constexpr std::string_view position_controller_refuses_time = "70451";
/// The message number that fits the filter.
[[nodiscard]] std::string_view time_constant_message(FilterContext const& context);

}  // namespace axisc::validator::checks
