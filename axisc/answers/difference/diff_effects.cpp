#include "axisc/answers/difference/diff_words.hpp"
#include "diagnostics/format_number.hpp"
#include "image/image_readings.hpp"

#include <cmath>

namespace axisc::says {

constexpr Sentence reading{"computed as (\"design\" of the settings)",
                           "gerechnet als (\"design\" der Einstellungen)"};
constexpr Sentence delay{"delay", "Verzögerung"};
constexpr Sentence settling{"settling time (0.01 %)", "Einschwingzeit (0,01 %)"};
constexpr Sentence longer{"longer than {time}", "länger als {time}"};
constexpr Sentence overshoot{"overshoot of a step", "Überschwingen eines Sprungs"};
constexpr Sentence gain{"gain at {frequency} Hz", "Verstärkung bei {frequency} Hz"};
constexpr Sentence corner{"deviation at a 90° corner, {feed} mm/min",
                          "Abweichung an einer 90°-Ecke, {feed} mm/min"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int figures = 4;

Wording decibel(double magnitude) {
  constexpr double nothing = 1e-10;
  if (magnitude < nothing) return "< -200 dB";
  return format_rounded(std::round(2000 * std::log10(magnitude)) / 100, figures + 1) + " dB";
}

}  // namespace

std::vector<DiffLine> DiffWords::effects(image::ChainDifference const& chain) const {
  auto const old_time = shown_.difference.before.cycle_time;
  auto const new_time = shown_.difference.after.cycle_time;
  std::vector<DiffLine> lines;
  if (chain.reading_before != chain.reading_after) {
    lines.push_back({say(says::reading), image::readings_text(chain.reading_before),
                     image::readings_text(chain.reading_after)});
  }
  lines.push_back({say(says::delay), time(chain.before.delay_cycles, old_time),
                   time(chain.after.delay_cycles, new_time)});
  lines.push_back({say(says::settling), settling(chain.before, old_time), settling(chain.after, new_time)});
  lines.push_back({say(says::overshoot),
                   format_rounded(chain.before.overshoot * 100, figures).in(language_) + " %",
                   format_rounded(chain.after.overshoot * 100, figures).in(language_) + " %"});
  for (auto const& gain : chain.gains) {
    lines.push_back({say(says::gain, {{"frequency", format_rounded(gain.frequency.value, figures)}}),
                     decibel(gain.before).in(language_), decibel(gain.after).in(language_)});
  }
  lines.push_back({say(says::corner, {{"feed", exact_number(shown_.feed_mm_per_min)}}),
                   corner(chain.before, old_time), corner(chain.after, new_time)});
  return lines;
}

std::string DiffWords::time(double cycles, design::CycleTime cycle_time) const {
  return format_rounded(cycles * cycle_time.seconds() * 1e3, figures).in(language_) + " ms";
}

std::string DiffWords::settling(image::ChainFigures const& chain, design::CycleTime cycle_time) const {
  if (!chain.settling_cycles) {
    return say(says::longer, {{"time", time(static_cast<double>(image::longest_settling), cycle_time)}});
  }
  return time(static_cast<double>(*chain.settling_cycles), cycle_time);
}

std::string DiffWords::corner(image::ChainFigures const& chain, design::CycleTime cycle_time) const {
  auto const deviation = corner_deviation_um(chain, shown_.feed_mm_per_min, cycle_time);
  return deviation ? format_rounded(*deviation, figures).in(language_) + " µm" : "-";
}

std::optional<double> corner_deviation_um(image::ChainFigures const& chain, double feed,
                                          design::CycleTime cycle_time) {
  if (!chain.corner_deviation) return std::nullopt;
  constexpr double um_per_mm = 1000;
  constexpr double seconds_per_minute = 60;
  return *chain.corner_deviation * feed * um_per_mm / seconds_per_minute * cycle_time.seconds();
}

}  // namespace axisc
