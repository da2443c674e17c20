// The mathematics of each filter type in one number type: an overload of realise() for each row of
// filter_kinds.
#pragma once

#include "design/filter_kinds.hpp"
#include "design/pi_def.hpp"
#include "design/pole_scale_def.hpp"
#include "design/prototypes_def.hpp"
#include "design/section_def.hpp"
#include "design/thiran_def.hpp"
#include "design/transformations_def.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace axisc::design {

/// Sections, or where there are none a delay of whole cycles.
template <typename Number>
struct FilterRealisation {
  std::vector<Section<Number>> sections{};
  std::uint32_t delay_cycles = 0;
};

template <FilterType type>
using Kind = std::integral_constant<FilterType, type>;

/// A delay this close to whole cycles counts as a pure delay.
inline constexpr double integer_delay_tolerance = 1e-9;

/// t = tan(π f T), the pre-warped characteristic frequency as the bilinear transform needs it.
template <typename Number>
[[nodiscard]] Number prewarped(Hertz frequency, CycleTime cycle_time) {
  using std::tan;
  return tan(pi<Number>() * cycle_time.periods_in<Number>(frequency));
}

/// t of the cut-off frequency 1/(2π τ): tan(T/(2 τ)).
template <typename Number>
[[nodiscard]] Number prewarped(Microseconds time_constant, CycleTime cycle_time) {
  using std::tan;
  return tan(1 / (2 * cycle_time.cycles_in<Number>(time_constant)));
}

[[nodiscard]] constexpr Discretisation method_of(FilterReading reading) {
  switch (reading) {
    case FilterReading::backward_euler: return Discretisation::backward_euler;
    case FilterReading::forward_euler: return Discretisation::forward_euler;
    case FilterReading::matched: return Discretisation::matched;
    case FilterReading::matched_poles: return Discretisation::matched_poles;
    case FilterReading::documented:
    case FilterReading::no_prewarping:
    case FilterReading::poles_at_frequency:
    case FilterReading::analogue_quality:
    case FilterReading::half_gain_at_frequency:
    case FilterReading::quality_of_poles:
    case FilterReading::bessel_delay:
    case FilterReading::allpass_phase: break;
  }
  return Discretisation::bilinear;
}

/// Without pre-warping for every method but the documented one: t = π f T.
[[nodiscard]] constexpr bool prewarps(FilterReading reading) {
  return method_of(reading) == Discretisation::bilinear && reading != FilterReading::no_prewarping;
}

template <typename Number>
[[nodiscard]] Discretiser<Number> discretiser(FilterSpecification const& wanted, CycleTime cycle_time) {
  FilterReading const reading = applied_reading(wanted);
  Discretiser<Number> made{.t = Number(0), .method = method_of(reading)};
  if (uses_time_constant(wanted.type)) {
    made.t = prewarps(reading) ? prewarped<Number>(wanted.time_constant, cycle_time)
                               : Number(1 / (2 * cycle_time.cycles_in<Number>(wanted.time_constant)));
  } else {
    made.t = prewarps(reading) ? prewarped<Number>(wanted.frequency, cycle_time)
                               : Number(pi<Number>() * cycle_time.periods_in<Number>(wanted.frequency));
  }
  return made;
}

/// Q_a = sin(2π f0 T)/(2 tan(π (f0/Q) T)) puts the digital -3 dB edges f0/Q apart;
/// sin 2α = 2 tan α/(1 + tan² α). Without pre-warping, and in some readings, it is Q itself.
template <typename Number>
[[nodiscard]] Number analogue_quality(FilterSpecification const& specification, CycleTime cycle_time,
                                      Number const& t) {
  using std::tan;
  FilterReading const reading = applied_reading(specification);
  if (!prewarps(reading) || reading == FilterReading::analogue_quality) return Number(specification.quality);
  Number const bandwidth =
      cycle_time.periods_in<Number>(specification.frequency) / Number(specification.quality);
  return t / ((1 + t * t) * tan(pi<Number>() * bandwidth));
}

template <typename Number>
[[nodiscard]] Poles<Number> poles_of(FilterSpecification const& specification) {
  auto poles = prototype_poles<Number>(specification.prototype, specification.order);
  FilterReading const reading = applied_reading(specification);
  if (reading == FilterReading::documented) return poles;
  Number const scale = pole_scale(reading, poles);
  for (auto& p : poles) p = {p.re * scale, p.im * scale};
  return poles;
}

/// Poles at -1/τ.
template <typename Number>
[[nodiscard]] FilterRealisation<Number> lag(std::uint32_t order, FilterSpecification const& wanted,
                                            CycleTime cycle_time) {
  Poles<Number> const poles(order, {Number(-1), Number(0)});
  return {.sections = lowpass(poles, discretiser<Number>(wanted, cycle_time))};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::lowpass>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  return {.sections = lowpass(poles_of<Number>(wanted), discretiser<Number>(wanted, cycle_time))};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::highpass>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  return {.sections = highpass(poles_of<Number>(wanted), discretiser<Number>(wanted, cycle_time))};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::bandpass>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  auto const make = discretiser<Number>(wanted, cycle_time);
  return {.sections = bandpass(poles_of<Number>(wanted), analogue_quality(wanted, cycle_time, make.t), make)};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::bandstop>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  auto const make = discretiser<Number>(wanted, cycle_time);
  return {.sections = bandstop(poles_of<Number>(wanted), analogue_quality(wanted, cycle_time, make.t), make)};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::allpass>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  return {.sections = allpass(poles_of<Number>(wanted), discretiser<Number>(wanted, cycle_time))};
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::pt1>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  return lag<Number>(1, wanted, cycle_time);
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::pt2>, FilterSpecification const& wanted,
                                                CycleTime cycle_time) {
  return lag<Number>(2, wanted, cycle_time);
}

template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(Kind<FilterType::time_delay>,
                                                FilterSpecification const& wanted, CycleTime cycle_time) {
  using std::abs;
  using std::floor;
  auto const D = cycle_time.cycles_in<Number>(wanted.time_constant);
  Number const whole = floor(D + Number(0.5));
  if (abs(D - whole) > Number(integer_delay_tolerance)) return {.sections = thiran(D)};
  return {.sections = {}, .delay_cycles = static_cast<std::uint32_t>(static_cast<double>(whole))};
}

namespace detail {

template <typename Number>
using Realiser = FilterRealisation<Number> (*)(FilterSpecification const&, CycleTime);

template <typename Number, std::size_t... row>
[[nodiscard]] constexpr auto realisers(std::index_sequence<row...>) {
  return std::array<Realiser<Number>, sizeof...(row)>{
      [](FilterSpecification const& wanted, CycleTime cycle_time) {
        return realise<Number>(Kind<filter_kinds[row].type>{}, wanted, cycle_time);
      }...};
}

}  // namespace detail

/// By the overload of its type. Expects a specification within its ranges.
template <typename Number>
[[nodiscard]] FilterRealisation<Number> realise(FilterSpecification const& wanted, CycleTime cycle_time) {
  static constexpr auto of_row = detail::realisers<Number>(std::make_index_sequence<filter_kinds.size()>{});
  return of_row[static_cast<std::size_t>(&kind_of(wanted.type) - filter_kinds.data())](wanted, cycle_time);
}

}  // namespace axisc::design
