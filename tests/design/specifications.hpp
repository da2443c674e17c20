// Specifications the tests walk through.
#pragma once

#include "design/filter_design.hpp"
#include "design/filter_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>

namespace axisc::design {

inline constexpr std::array<Prototype, 3> every_prototype{Prototype::critical_damping, Prototype::butterworth,
                                                          Prototype::bessel};
inline constexpr std::array<FilterType, 8> every_type{
    FilterType::lowpass, FilterType::highpass, FilterType::bandpass, FilterType::bandstop,
    FilterType::allpass, FilterType::pt1,      FilterType::pt2,      FilterType::time_delay};

inline FilterSpecification filter_of(FilterType type, Prototype prototype, std::uint32_t order,
                                     double frequency, double quality = 1) {
  return {.type = type, .prototype = prototype, .order = order, .frequency = {frequency}, .quality = quality};
}

inline FilterSpecification lag_of(FilterType type, double microseconds) {
  return {.type = type, .time_constant = {microseconds}};
}

inline std::uint32_t highest_order(FilterType type) {
  return uses_quality(type) ? 3 : 6;
}

struct Case {
  FilterSpecification specification;
  CycleTime cycle_time;
};

inline std::ostream& operator<<(std::ostream& out, Case const& c) {
  auto const& s = c.specification;
  return out << "type " << int(s.type) << " prototype " << int(s.prototype) << " order " << s.order << " f0 "
             << s.frequency.value << " quality " << s.quality << " time constant " << s.time_constant.value
             << " share " << s.share_percent << " T " << c.cycle_time.nanoseconds << " ns";
}

/// Anything the ranges allow: T from 62.5 us to 4 ms, frequencies from 0.1 Hz to 0.499/T, logarithmically.
class RandomCases {
 public:
  explicit RandomCases(std::uint32_t seed) : random_(seed) {}

  Case next() {
    static constexpr std::array<std::uint32_t, 7> cycle_times{62'500,    125'000,   250'000,  500'000,
                                                              1'000'000, 2'000'000, 4'000'000};
    CycleTime const cycle_time{cycle_times[index(cycle_times.size())]};
    double const highest = 0.998 * cycle_time.nyquist().value;
    FilterType const type = every_type[index(every_type.size())];
    double const T = cycle_time.microseconds();
    return {{.type = type,
             .prototype = every_prototype[index(every_prototype.size())],
             .order = 1 + static_cast<std::uint32_t>(index(highest_order(type))),
             .frequency = {0.1 * std::pow(highest / 0.1, uniform())},
             .quality = 1 + 9 * uniform(),
             .time_constant = {type == FilterType::time_delay ? 5.999 * T * uniform()
                                                              : T * std::pow(1e4, uniform())},
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
