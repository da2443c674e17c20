// The settings of a control (`design` of axisc.json) that a comparison determines.
#pragma once

#include "analysis/comparison/verdict.hpp"
#include "design/readings.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace axisc::comparison {

/// A setting that the recording and the lists do not determine.
struct OpenSetting {
  std::string_view key;                         ///< "filters", "kernels" or "cycle_time"
  std::vector<std::string_view> possible = {};  ///< names of departures; "" for what is in force
};

struct DeterminedSettings {
  design::Readings readings;  ///< those in force, changed where all readings that fit agree
  std::vector<OpenSetting> open = {};
};

/// The settings under which axisc computes what a recording shows; the lists were compiled with `current`.
/// None where the recording cannot tell, nothing fits, the departure is one of values (a filter that was on
/// or off) and not of arithmetic, or no setting is determined.
[[nodiscard]] std::optional<DeterminedSettings> settings_of(Comparison const& comparison,
                                                            design::Readings const& current);

/// Settings that the fitting readings, and those that compute the same from these lists, disagree about.
[[nodiscard]] std::vector<OpenSetting> open_settings(Comparison const& comparison);

}  // namespace axisc::comparison
