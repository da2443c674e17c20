// Why recordings show no resonance, and what to record.
#pragma once

#include "analysis/tuning/identification/modes.hpp"
#include "axisc/environment/failure.hpp"

#include <string>
#include <vector>

namespace axisc {

/// Of a search without modes: a sentence for each kind of evidence that the recordings allow. AX9005.
[[nodiscard]] Failure measured_refusal(std::vector<std::string> const& paths,
                                       tuning::ModeSearch const& search);

}  // namespace axisc
