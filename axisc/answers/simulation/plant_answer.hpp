// What `simulate --plant` says of an axis in its closed loop.
#pragma once

#include "axisc/answers/simulation/plant_run.hpp"
#include "presentation/document.hpp"

namespace axisc {

[[nodiscard]] presentation::Document plant_answer(ClosedLoopFigures const& figures);

}  // namespace axisc
