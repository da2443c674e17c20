// The values that the control uses, and where each comes from, as an answer.
#pragma once

#include "axisc/checking/path_machine.hpp"
#include "presentation/document.hpp"

#include <string>
#include <vector>

namespace axisc {

struct ValuesQuestion {
  MachineRequest machine;
  std::vector<std::string> words;  ///< an axis, then parameters: see chosen_values.hpp
  bool all = false;                ///< instead of parameters: every one that a list sets
};

/// A value as the merged lists give it: with unit, meaning and origin, and with what the control replaces it
/// by where a finding tells. Findings do not prevent it. Failure where the input cannot be read, and for
/// words that name nothing.
[[nodiscard]] presentation::Document values_answer(Workspace& workspace, ValuesQuestion const& question);

}  // namespace axisc
