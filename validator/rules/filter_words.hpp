// How the rules about filters name things: parameters, values with units, the control's reactions.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/filter_view.hpp"
#include "validator/rule.hpp"

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

/// What the control does; `messages` replaces the row's numbers for this case.
void react(Finding& finding, std::string_view messages, Message reaction, std::string value = {});

/// Says which default counts where no list sets `value`.
void note_default(Finding& finding, EffectiveValue const& value);

/// Points at the type where a list sets it; else notes which type counts by default.
void relate_type(Finding& finding, FilterView const& filter);

/// The one of 50663 (path axis), 60311 (spindle), 70451 (position controller) that fits.
[[nodiscard]] std::string_view time_constant_message(FilterContext const& context);

}  // namespace axisc::validator::checks
