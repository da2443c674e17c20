// What counts of a value that says how fast an axis may be driven.
#pragma once

#include "configuration/machine/path_dynamics.hpp"

#include <optional>
#include <string_view>

namespace axisc::validator {

/// Of a parameter of gear 0, in its own unit.
struct DrivenValue {
  double counts = 0;
  std::string_view cap;  ///< the parameter that limits it: "P-AXIS-00008"
  /// Of a ramp time: a/tr, with the acceleration that is built up or taken back in it; mm/s³ or °/s³.
  std::optional<double> jerk = {};
};

/// `dynamics` of axis_dynamics(), `pattern` as in the catalogue; none for other parameters.
[[nodiscard]] std::optional<DrivenValue> driven_value(machine::AxisDynamics const& dynamics,
                                                      std::string_view pattern);

}  // namespace axisc::validator
