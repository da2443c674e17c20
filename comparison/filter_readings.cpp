#include "comparison/filter_readings.hpp"

#include "comparison/rediscretised.hpp"
#include "design/filter_kinds.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace axisc::comparison::says {

constexpr Sentence no_prewarping{"bilinear transform without pre-warping",
                                 "bilineare Transformation ohne Frequenzvorverzerrung"};
constexpr Sentence backward_euler{"backward Euler method", "Euler-Rückwärtsverfahren"};
constexpr Sentence forward_euler{"forward Euler method", "Euler-Vorwärtsverfahren"};
constexpr Sentence matched{"matched poles and zeros", "angepasste Pole und Nullstellen (matched z)"};
constexpr Sentence matched_poles{"matched poles, no zeros at infinity",
                                 "angepasste Pole, keine Nullstellen im Unendlichen"};
constexpr Sentence pole_at_frequency{"the poles lie at fg_f0 (below -3 dB there for orders above 1)",
                                     "die Pole liegen bei fg_f0 (dort unter -3 dB bei Ordnungen über 1)"};
constexpr Sentence analogue_quality{"the quality counts before the bilinear transform",
                                    "die Güte gilt vor der bilinearen Transformation"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

using design::CycleTime;
using design::FilterSpecification;
using design::FilterType;
using Result = std::optional<Link>;

constexpr double pi = std::numbers::pi;

bool is_band(FilterType type) {
  return type == FilterType::bandpass || type == FilterType::bandstop;
}

Link designed(FilterSpecification const& wanted, CycleTime cycle_time) {
  return link_of(design::design_filter(wanted, cycle_time, design::Precision::quick));
}

/// The frequency whose pre-warped value is `t`.
design::Hertz frequency_of(double t, CycleTime cycle_time) {
  return {std::atan(t) / (pi * cycle_time.seconds())};
}

/// The quality that makes the analogue one what the list says.
void keep_analogue_quality(FilterSpecification& wanted, double listed, CycleTime cycle_time) {
  double const angle = 2 * pi * wanted.frequency.value * cycle_time.seconds();
  double const bandwidth = std::atan(std::sin(angle) / (2 * listed)) / (pi * cycle_time.seconds());
  wanted.quality = wanted.frequency.value / bandwidth;
}

FilterSpecification not_prewarped(FilterSpecification wanted, CycleTime cycle_time) {
  if (wanted.type == FilterType::pt1 || wanted.type == FilterType::pt2) {
    double const half = 1 / (2 * cycle_time.cycles(wanted.time_constant));
    wanted.time_constant = {cycle_time.microseconds() / (2 * std::atan(half))};
    return wanted;
  }
  double const quality = wanted.quality;
  wanted.frequency = frequency_of(pi * wanted.frequency.value * cycle_time.seconds(), cycle_time);
  if (is_band(wanted.type)) keep_analogue_quality(wanted, quality, cycle_time);
  return wanted;
}

Result without_prewarping(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type == FilterType::time_delay) return std::nullopt;
  return designed(not_prewarped(wanted, cycle_time), cycle_time);
}

template <Discretisation discretisation>
Result by(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type == FilterType::time_delay) return std::nullopt;
  return rediscretised(designed(not_prewarped(wanted, cycle_time), cycle_time), discretisation);
}

Result poles_at_frequency(FilterSpecification const& listed, CycleTime cycle_time) {
  FilterSpecification wanted = listed;
  bool const is_damped = wanted.prototype == design::Prototype::critical_damping && wanted.order > 1;
  double const t = std::tan(pi * wanted.frequency.value * cycle_time.seconds());
  double const shift = std::sqrt(std::pow(2.0, 1.0 / wanted.order) - 1);
  if (!is_damped) return std::nullopt;
  if (wanted.type == FilterType::lowpass || wanted.type == FilterType::allpass) {
    wanted.frequency = frequency_of(t * shift, cycle_time);
  } else if (wanted.type == FilterType::highpass) {
    wanted.frequency = frequency_of(t / shift, cycle_time);
  } else {
    return std::nullopt;
  }
  return designed(wanted, cycle_time);
}

Result with_analogue_quality(FilterSpecification const& listed, CycleTime cycle_time) {
  FilterSpecification wanted = listed;
  if (!is_band(wanted.type)) return std::nullopt;
  keep_analogue_quality(wanted, wanted.quality, cycle_time);
  return designed(wanted, cycle_time);
}

constexpr std::array<FilterReading, 7> rows{
    {{{"no-prewarping", says::no_prewarping}, without_prewarping},
     {{"backward-euler", says::backward_euler}, by<Discretisation::backward_euler>},
     {{"forward-euler", says::forward_euler}, by<Discretisation::forward_euler>},
     {{"matched", says::matched}, by<Discretisation::matched>},
     {{"matched-poles", says::matched_poles}, by<Discretisation::matched_poles>},
     {{"poles-at-frequency", says::pole_at_frequency}, poles_at_frequency},
     {{"analogue-quality", says::analogue_quality}, with_analogue_quality}}};

}  // namespace

std::span<FilterReading const> filter_readings() {
  return rows;
}

}  // namespace axisc::comparison
