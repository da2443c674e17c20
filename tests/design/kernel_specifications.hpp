// Kernels the tests walk through.
#pragma once

#include "design/kernels/kernel_design.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>

namespace axisc::design {

inline KernelSpecification kernel_of(KernelType type, std::uint32_t order, double share_percent = 100) {
  return {.type = type, .order = order, .share_percent = share_percent};
}

inline KernelSpecification sinc_of(std::uint32_t order, double cut_off) {
  return {.type = KernelType::windowed_sinc, .order = order, .frequency = {cut_off}};
}

inline KernelSpecification novib_of(double frequency, double share_percent = 100) {
  return {.type = KernelType::novib, .frequency = {frequency}, .share_percent = share_percent};
}

struct KernelCase {
  KernelSpecification specification;
  CycleTime cycle_time;
};

inline std::ostream& operator<<(std::ostream& out, KernelCase const& c) {
  auto const& s = c.specification;
  return out << "type " << int(s.type) << " order " << s.order << " frequency " << s.frequency.value
             << " quality " << s.quality << " share " << s.share_percent << " T " << c.cycle_time.nanoseconds
             << " ns";
}

inline constexpr std::array<KernelType, 5> every_kernel{KernelType::moving_average, KernelType::gaussian,
                                                        KernelType::windowed_sinc, KernelType::time_delay,
                                                        KernelType::novib};
inline constexpr std::array<std::uint32_t, 5> kernel_cycle_times{125'000, 250'000, 1'000'000, 2'000'000,
                                                                 4'000'000};

/// Anything the ranges allow.
class RandomKernels {
 public:
  explicit RandomKernels(std::uint32_t seed) : random_(seed) {}

  KernelCase next() {
    CycleTime const cycle_time{kernel_cycle_times[index(kernel_cycle_times.size())]};
    KernelType const type = every_kernel[index(every_kernel.size())];
    double const lowest = type == KernelType::novib ? lowest_novib_frequency(cycle_time).value : 1;
    return {{.type = type,
             .order = 1 + static_cast<std::uint32_t>(index(
                              type == KernelType::time_delay ? longest_kernel_delay : longest_kernel_order)),
             .frequency = {lowest * std::pow(0.999 * cycle_time.nyquist().value / lowest, uniform())},
             .quality = 1 - uniform(),
             .share_percent = index(2) == 0 ? 100 : 100 * uniform()},
            cycle_time};
  }

 private:
  // Not the standard distributions: their sequences differ between libraries.
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }
  std::size_t index(std::size_t count) { return random_() % count; }

  std::mt19937 random_;
};

}  // namespace axisc::design
