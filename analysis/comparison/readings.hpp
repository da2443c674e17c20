// What a control may make of parameters whose arithmetic the manuals leave open: each reading is one
// departure from what axisc computes.
#pragma once

#include "analysis/comparison/chain.hpp"
#include "design/filter_specification.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/readings.hpp"
#include "design/units.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::comparison {

/// A `#FILTER` command while the recording ran, as far as it concerns the axis.
struct KernelSwitch {
  std::size_t cycle = 0;
  std::optional<design::KernelSpecification> kernel{};  ///< none: off
  std::size_t fade_cycles = 0;
};

/// The setpoint chain of an axis as the lists describe it.
struct Configured {
  design::CycleTime cycle_time;
  std::vector<design::FilterSpecification> filters;
  std::optional<design::KernelSpecification> kernel;
  bool kernel_on = true;                 ///< at the start of the recording, according to the lists
  std::vector<KernelSwitch> switches{};  ///< by rising cycle
};

/// The linear-phase filter on or off all the time, without commands.
[[nodiscard]] Configured steady(Configured configured, bool on);

/// A departure: its name in JSON and what it means.
struct Departure {
  std::string_view id;
  SentenceRef meaning;
};

/// Names of departures that settings cannot express; the first three lead back to what axisc computes without
/// settings.
inline constexpr std::string_view documented_filters = "documented-filters";
inline constexpr std::string_view documented_kernels = "documented-kernels";
inline constexpr std::string_view documented_cycle_time = "documented-cycle-time";
inline constexpr std::string_view cycle_time_double = "cycle-time-double";
inline constexpr std::string_view cycle_time_half = "cycle-time-half";
inline constexpr std::string_view cycle_time_fourfold = "cycle-time-fourfold";
inline constexpr std::string_view cycle_time_quarter = "cycle-time-quarter";

/// A chain and the departures that lead to it; none for what axisc computes.
struct Reading {
  std::vector<Departure> departures;
  Chain chain;
  /// Other departures that lead to the same chain from these lists, perhaps whole cycles later: each is
  /// equivalent to `departures`. For other lists, such as ones with an even order, they may make different
  /// chains.
  std::vector<std::vector<Departure>> equals{};
};

/// The first is what axisc computes; then readings with one departure, then with two. Departures that do not
/// change what axisc computes from these lists are left out.
[[nodiscard]] std::vector<Reading> readings(Configured const& configured);

}  // namespace axisc::comparison
