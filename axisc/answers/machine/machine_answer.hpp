// What an input says about the machine, as an answer.
#pragma once

#include "presentation/document.hpp"
#include "validator/loading/loading.hpp"

#include <string>
#include <vector>

namespace axisc {

/// A file that is missing, cannot be read or is of another kind.
struct MachineLack {
  std::string place;  ///< where it is named: "x.lis:7"
  presentation::Words reason;
};

[[nodiscard]] std::vector<MachineLack> lacks_of(validator::LoadedMachine const& machine,
                                                SourceSet const& sources);

/// "x.lis:7".
[[nodiscard]] std::string place_text(Place const& place, SourceSet const& sources);

/// Axes, channels and cycle time, and where each was read. In JSON a machine file that means the same, whose
/// paths count from the working folder; what the machine lacks only people see.
[[nodiscard]] presentation::Document machine_answer(validator::LoadedMachine const& machine,
                                                    SourceSet const& sources);

}  // namespace axisc
