#include "comparison/filter_readings.hpp"

#include "comparison/prototype_gain.hpp"
#include "comparison/rediscretised.hpp"
#include "design/filter_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

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
constexpr Sentence impulse_invariant{"impulse-invariant", "impulsinvariant"};
constexpr Sentence step_invariant{"step-invariant (zero-order hold)",
                                  "sprunginvariant (Halteglied nullter Ordnung)"};
constexpr Sentence half_gain{"-6 dB at fg_f0", "-6 dB bei fg_f0"};
constexpr Sentence pole_quality{"the quality is that of the poles, not centre by bandwidth",
                                "die Güte ist die der Pole, nicht Mitte durch Bandbreite"};
constexpr Sentence bessel_delay{"Bessel filters delay by 1/(2π fg_f0) at rest",
                                "Bessel-Filter verzögern im Stillstand um 1/(2π fg_f0)"};
constexpr Sentence allpass_phase{"all-passes turn the phase by half of its whole angle at fg_f0",
                                 "Allpässe drehen die Phase bei fg_f0 um die Hälfte des ganzen Winkels"};

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

bool is_lag(FilterSpecification const& wanted) {
  return wanted.type == FilterType::lowpass || wanted.type == FilterType::pt1 ||
         wanted.type == FilterType::pt2;
}

FilterSpecification moved(FilterSpecification wanted, double factor, CycleTime cycle_time) {
  wanted.frequency =
      frequency_of(std::tan(pi * wanted.frequency.value * cycle_time.seconds()) * factor, cycle_time);
  return wanted;
}

Result half_gain(FilterSpecification const& wanted, CycleTime cycle_time) {
  constexpr double quarter = 0.25;
  if (wanted.type != FilterType::lowpass && wanted.type != FilterType::highpass) return std::nullopt;
  double const shift = frequency_with_power(wanted.prototype, wanted.order, quarter);
  return designed(moved(wanted, wanted.type == FilterType::lowpass ? 1 / shift : shift, cycle_time),
                  cycle_time);
}

Result delay_of_bessel(FilterSpecification const& wanted, CycleTime cycle_time) {
  bool const is_kind = wanted.type == FilterType::lowpass || wanted.type == FilterType::allpass;
  if (!is_kind || wanted.prototype != design::Prototype::bessel || wanted.order < 2) return std::nullopt;
  return designed(moved(wanted, bessel_cutoff(wanted.order), cycle_time), cycle_time);
}

/// Equal poles at -1 before the transformation to a band.
Result quality_of_poles(FilterSpecification const& listed, CycleTime cycle_time) {
  FilterSpecification wanted = listed;
  bool const is_damped = wanted.prototype == design::Prototype::critical_damping && wanted.order > 1;
  if (!is_band(wanted.type) || !is_damped) return std::nullopt;
  double const shift = std::sqrt(std::pow(2.0, 1.0 / wanted.order) - 1);
  wanted.quality *= wanted.type == FilterType::bandstop ? shift : 1 / shift;
  return designed(wanted, cycle_time);
}

/// Phase of the all-pass at the angle, in radians and without jumps: sections turn it by at most a whole turn each.
double turned(Link const& link, double angle) {
  double sum = 0;
  for (auto const& section : link.sections) {
    auto const [one, other] = design::poles(section);
    auto const e = std::polar(1.0, -angle);
    for (auto const pole : {one, other}) {
      if (pole == 0.0) continue;
      // (z^-1 - conj p)/(1 - p z^-1), relative to 0
      sum += angle - 2 * std::arg(1.0 - pole * e) + 2 * std::arg(1.0 - pole);
    }
  }
  return sum;
}

Result phase_of_allpass(FilterSpecification const& wanted, CycleTime cycle_time) {
  bool const is_kind = wanted.type == FilterType::allpass && wanted.order > 1;
  if (!is_kind || wanted.prototype == design::Prototype::butterworth) return std::nullopt;
  double const angle = 2 * pi * wanted.frequency.value * cycle_time.seconds();
  double low = 0.05, high = 20;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    double const middle = std::sqrt(low * high);
    bool const turns_less = std::abs(turned(designed(moved(wanted, middle, cycle_time), cycle_time), angle)) <
                            wanted.order * pi / 2;
    (turns_less ? high : low) = middle;
  }
  return designed(moved(wanted, std::sqrt(low * high), cycle_time), cycle_time);
}

constexpr std::size_t parts_of_cycle = 64;

/// The analogue filter's answer to a step, in parts of a cycle. The bilinear transform of a short cycle makes of the jump a
/// ramp between two samples, so that these are half a part behind it.
std::vector<double> analogue_step(FilterSpecification wanted, CycleTime cycle_time) {
  wanted.share_percent = 100;
  auto const link = designed(wanted, CycleTime{cycle_time.nanoseconds / std::uint32_t{parts_of_cycle}});
  constexpr std::size_t longest = 4000;
  std::size_t const cycles = std::min(longest, settling_cycles({designed(wanted, cycle_time)}) + 4);
  std::vector<double> step(cycles * parts_of_cycle + 1, 1.0);
  step.front() = 0;
  auto answer = respond({link}, step);
  answer.erase(answer.begin());
  return answer;
}

/// Taps that sum up to the share, and the rest passes.
Link with_share(std::vector<double> taps, double share_percent) {
  double const sum = std::accumulate(taps.begin(), taps.end(), 0.0);
  for (double& tap : taps) tap *= share_percent / 100 / sum;
  taps.front() += 1 - share_percent / 100;
  return {.taps = std::move(taps)};
}

Result by_impulse(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (!is_lag(wanted)) return std::nullopt;
  auto const step = analogue_step(wanted, cycle_time);
  auto const slope = [&](std::size_t at) { return step[at] - step[at - 1]; };
  std::vector<double> taps{3 * slope(1) - 3 * slope(2) + slope(3)};
  for (std::size_t at = parts_of_cycle; at < step.size(); at += parts_of_cycle) taps.push_back(slope(at));
  return with_share(std::move(taps), wanted.share_percent);
}

Result by_step(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (!is_lag(wanted)) return std::nullopt;
  auto const step = analogue_step(wanted, cycle_time);
  std::vector<double> taps{0.0};
  double last = 0;
  for (std::size_t at = parts_of_cycle; at < step.size(); at += parts_of_cycle) {
    double const here = (step[at] + step[at - 1]) / 2;
    taps.push_back(here - last);
    last = here;
  }
  return with_share(std::move(taps), wanted.share_percent);
}

constexpr std::array<FilterReading, 13> rows{
    {{{"no-prewarping", says::no_prewarping}, without_prewarping},
     {{"backward-euler", says::backward_euler}, by<Discretisation::backward_euler>},
     {{"forward-euler", says::forward_euler}, by<Discretisation::forward_euler>},
     {{"matched", says::matched}, by<Discretisation::matched>},
     {{"matched-poles", says::matched_poles}, by<Discretisation::matched_poles>},
     {{"poles-at-frequency", says::pole_at_frequency}, poles_at_frequency},
     {{"analogue-quality", says::analogue_quality}, with_analogue_quality},
     {{"impulse-invariant", says::impulse_invariant}, by_impulse},
     {{"step-invariant", says::step_invariant}, by_step},
     {{"half-gain-at-frequency", says::half_gain}, half_gain},
     {{"quality-of-poles", says::pole_quality}, quality_of_poles},
     {{"bessel-delay", says::bessel_delay}, delay_of_bessel},
     {{"allpass-phase", says::allpass_phase}, phase_of_allpass}}};

}  // namespace

std::span<FilterReading const> filter_readings() {
  return rows;
}

}  // namespace axisc::comparison
