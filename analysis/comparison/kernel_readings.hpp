// Readings of a linear-phase kernel.
#pragma once

#include "analysis/comparison/readings.hpp"

#include <span>

namespace axisc::comparison {

struct KernelReading {
  Departure departure;
  /// The causal taps; empty where it changes nothing about that type.
  std::vector<double> (*taps)(design::KernelSpecification const& wanted, design::CycleTime cycle_time);
};

[[nodiscard]] std::span<KernelReading const> kernel_readings();

}  // namespace axisc::comparison
