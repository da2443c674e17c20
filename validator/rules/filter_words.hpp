// How the rules about filters name things: parameters, values with units, the control's reactions.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/views/filter_view.hpp"
#include "validator/engine/rule.hpp"

#include <string>
#include <string_view>

namespace axisc::validator::checks {

/// "filter[0]", "lr_param.add_interface.filter[0]".
[[nodiscard]] std::string filter_name(FilterView const& filter);
/// The word of a symbol, also where its number or the internal default counts: "BUTTERWORTH".
[[nodiscard]] std::string symbol_word(EffectiveValue const& value);

/// A value for a person: six significant digits, integers in full.
[[nodiscard]] std::string number(double value);
/// "10.9" for a share of 0.109: one decimal, two significant digits below a tenth of a percent.
[[nodiscard]] std::string percent(double share);
/// "1000 µs".
[[nodiscard]] std::string microseconds(double value);
/// "12 ms".
[[nodiscard]] std::string milliseconds(double value);

/// "12000 µs (12 ms) are 12 cycles of 1000 µs", of a time in microseconds.
[[nodiscard]] Message time_in_cycles(double time, design::CycleTime cycle_time);

/// What the control does; `value` is what it goes on with.
void react(Finding& finding, Message reaction, std::string value = {});
/// Where only one or some of the row's message numbers fit: `control` is these.
void react(Finding& finding, std::string_view control, Message reaction, std::string value = {});

/// Says which default counts where no list sets `value`.
void note_default(Finding& finding, EffectiveValue const& value);

/// Points at a type where a list sets it.
void relate_set_type(Finding& finding, EffectiveValue const& type);
/// Points at the type where a list sets it; else notes which type counts by default.
void relate_type(Finding& finding, FilterView const& filter);

/// What the control says of a time constant that it refuses: on a path axis, on a spindle, in the position controller.
inline constexpr std::string_view path_refuses_time = "50663";
inline constexpr std::string_view spindle_refuses_time = "60311";
inline constexpr std::string_view position_controller_refuses_time = "70451";
/// The one of them that fits.
[[nodiscard]] std::string_view time_constant_message(FilterContext const& context);

}  // namespace axisc::validator::checks
