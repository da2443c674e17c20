// The naive image's sections of kernels, slots, channels and banks.
#pragma once

#include "configuration/machine/machine.hpp"
#include "naive_bytes.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace axisc::test {

struct NaiveKernelSections {
  NaiveBytes kernels, tails, slots, groups, members, banks, choices;
};

/// What a kernel adds to the figures of an axis that starts with it.
struct NaiveKernelFigures {
  double peak_gain = 1;
  double delay_cycles = 0;
};
[[nodiscard]] NaiveKernelFigures kernel_at_start(machine::AxisConfiguration const& axis,
                                                 design::CycleTime cycle_time);

/// `peak_gain(axis)` is that of the standard filters in series.
[[nodiscard]] NaiveKernelSections naive_kernel_sections(
    machine::Machine const& machine, bool strip, NaiveStores& stores,
    std::function<double(machine::AxisConfiguration const&)> const& peak_gain);

/// The fewest cycles, found by trying one after the other; 0 where 4096 are not enough.
[[nodiscard]] std::uint32_t naive_fade(long double distance, long double velocity, long double acceleration);

}  // namespace axisc::test
