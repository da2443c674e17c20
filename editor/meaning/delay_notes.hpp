// What the delays of an axis come to, for the editor: beside the parameters that make them.
#pragma once

#include "diagnostics/sentence.hpp"
#include "editor/reading/open_list.hpp"
#include "schema/catalogue.hpp"

#include <string>

namespace axisc::editor {

/// What the parameter contributes at the start of programs, and what position and feedforward come to with
/// it, for a hover; empty for parameters that delay nothing, and without an axis. Cost: one design per
/// filter.
[[nodiscard]] std::string delay_sentences(OpenList const& list, schema::NameLookup const& found,
                                          Language language);

/// "1.5 cycles" for a delay time; empty for other parameters.
[[nodiscard]] std::string delay_in_cycles(OpenList const& list, schema::NameLookup const& found,
                                          grammar::Assignment const& line, Language language);

/// "velocity feedforward leads by 3 cycles: 150 µm at a_max"; empty where the velocity is not fed forward,
/// and where it arrives together with the position.
[[nodiscard]] std::string lead_line(OpenList const& list, Language language);

}  // namespace axisc::editor
