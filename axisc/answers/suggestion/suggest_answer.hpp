// What `axisc suggest` says.
#pragma once

#include "axisc/answers/suggestion/suggested.hpp"
#include "diagnostics/wording.hpp"
#include "presentation/document.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

[[nodiscard]] presentation::Document suggest_answer(Suggested const& suggested);

/// Which of the filters `index` is, and its NC command.
[[nodiscard]] presentation::Document chosen_answer(Suggestion const& suggestion, std::size_t index);

/// "2 balanced, 3 least vibration": every sense that an alternative stands for, with its number; `mark`
/// follows the one that is recommended.
[[nodiscard]] Wording senses_of(Suggestion const& suggestion, std::size_t index, Wording const& mark = {});

/// "48 Hz, 112 Hz".
[[nodiscard]] Wording resonances_of(tuning::Task const& task);

// Parts of it.

/// For programs; without a key its members are those of the enclosing object.
[[nodiscard]] presentation::Section setting_section(std::string key, Suggestion const& suggestion,
                                                    Setting const& setting);

/// For people: a column for each setting.
[[nodiscard]] presentation::Table settings_table(Suggestion const& suggestion);

/// "LOWPASS order 2, 30 Hz + Gaussian order 40".
[[nodiscard]] Wording name_of(tuning::Chain const& chain);

/// Of a length in position units.
[[nodiscard]] presentation::Quantity length_of(double units);

/// As people see it.
[[nodiscard]] presentation::Quantity delay_of(Suggestion const& suggestion, tuning::Figures const& figures);

/// Of an answer that has looked for it.
[[nodiscard]] presentation::Section damping_section(Suggested const& suggested);

/// What moves the axis, and how much of it reaches each resonance.
void add_excitation(std::vector<presentation::Block>& blocks, Suggested const& suggested);

/// Ramp times and what they cost, of an answer that has compared them.
[[nodiscard]] presentation::Section ramp_section(Suggested const& suggested);

/// The number and the setting, of an answer that has one.
[[nodiscard]] presentation::Words ramps_name(RampAnswer const& answer);

/// The number and the setting, of an answer that has one.
[[nodiscard]] presentation::Words damping_name(tuning::Damping const& damping);

/// The lines of each axis, and the findings that the lists would have then. People see axes that get the same
/// lines together.
void add_lines(std::vector<presentation::Block>& blocks, std::vector<AxisLines> const& axes,
               std::vector<std::string> const& findings);

}  // namespace axisc
