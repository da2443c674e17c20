// Why recordings show no mass, and what to record.
#pragma once

#include "analysis/tuning/rigid_model/rigid_model.hpp"
#include "axisc/environment/failure.hpp"

#include <string>
#include <vector>

namespace axisc {

/// Of a model without a mass.
[[nodiscard]] Failure model_refusal(std::vector<std::string> const& paths, tuning::RigidModel const& model);

}  // namespace axisc
