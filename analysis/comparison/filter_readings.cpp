#include "analysis/comparison/filter_readings.hpp"

#include <algorithm>
#include <array>

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
constexpr Sentence documented_filter{"standard filters as axisc computes them without settings",
                                     "Standardfilter, wie axisc sie ohne Einstellungen rechnet"};
constexpr Sentence analogue_quality{"the quality counts before the bilinear transform",
                                    "die Güte gilt vor der bilinearen Transformation"};
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

using WantedFilter = design::FilterReading;

/// None where the reading means nothing for the type, or where no runtime would execute one of the sections.
template <WantedFilter reading>
std::optional<Link> read_as(design::FilterSpecification const& listed, design::CycleTime cycle_time) {
  design::FilterSpecification wanted = listed;
  wanted.reading = reading;
  if (design::applied_reading(wanted) != reading) return std::nullopt;
  auto const made = design::design_filter(wanted, cycle_time, design::Precision::quick);
  bool const is_executable = std::all_of(made.sections.begin(), made.sections.end(), design::is_loadable);
  return is_executable ? std::optional(link_of(made)) : std::nullopt;
}

template <WantedFilter reading>
constexpr FilterReading row(SentenceRef meaning) {
  return {{word_of(reading), meaning}, read_as<reading>};
}

// The last one differs from the listed chain where settings ask for another reading.
constexpr std::array<FilterReading, 12> filter_rows{
    row<WantedFilter::no_prewarping>(says::no_prewarping),
    row<WantedFilter::backward_euler>(says::backward_euler),
    row<WantedFilter::forward_euler>(says::forward_euler),
    row<WantedFilter::matched>(says::matched),
    row<WantedFilter::matched_poles>(says::matched_poles),
    row<WantedFilter::poles_at_frequency>(says::pole_at_frequency),
    row<WantedFilter::analogue_quality>(says::analogue_quality),
    row<WantedFilter::half_gain_at_frequency>(says::half_gain),
    row<WantedFilter::quality_of_poles>(says::pole_quality),
    row<WantedFilter::bessel_delay>(says::bessel_delay),
    row<WantedFilter::allpass_phase>(says::allpass_phase),
    {{documented_filters, says::documented_filter}, read_as<WantedFilter::documented>}};

}  // namespace

std::span<FilterReading const> filter_readings() {
  return filter_rows;
}

}  // namespace axisc::comparison
