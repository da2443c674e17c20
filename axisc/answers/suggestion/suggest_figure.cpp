#include "axisc/answers/suggestion/suggest_figure.hpp"

#include "analysis/tuning/suggestion/impulse_response.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/suggestion/suggest_answer.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::says {

constexpr Sentence nothing_to_draw{"there is nothing to draw: no filters are suggested",
                                   "es gibt nichts zu zeichnen: es werden keine Filter vorgeschlagen"};
constexpr Sentence figure_title{"Suggestions for axis {axis}", "Vorschläge für Achse {axis}"};
constexpr Sentence described{
    "{setting}: {chain}, {vibration} % of the vibration remain, {delay} ms delay",
    "{setting}: {chain}, {vibration} % der Schwingung bleiben, {delay} ms Verzögerung"};
constexpr Sentence step{"step response", "Sprungantwort"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double lowest_gain = -60;  ///< dB; below it nothing is left to be seen
constexpr double highest_gain = 10;
constexpr int frequencies = 400;

std::string say(Language language, SentenceRef text, std::vector<Argument> arguments = {}) {
  return render({text, std::move(arguments)}, language);
}

struct Shown {
  std::string name;
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  Setting const* setting = nullptr;
  tuning::ImpulseResponse response = {};
};

std::vector<Shown> shown_settings(Suggestion const& suggestion, Language language) {
  std::vector<Shown> shown;
  if (suggestion.present) {
    shown.push_back({.name = say(language, labels::present),
                     .role = pictures::Role::before,
                     .colour = tuning::senses,
                     .setting = &*suggestion.present});
  }
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    auto name = senses_of(suggestion, i).in(language);
    if (name.empty()) continue;
    shown.push_back(
        {.name = std::move(name), .colour = i, .setting = &suggestion.alternatives.at(i).setting});
  }
  std::vector<tuning::Chain> chains;
  chains.reserve(shown.size());
  for (auto const& one : shown) chains.push_back(one.setting->chain);
  auto responses = tuning::impulse_responses(chains, suggestion.cycle_time);
  for (std::size_t i = 0; i < shown.size(); ++i) shown[i].response = std::move(responses[i]);
  return shown;
}

pictures::Curve curve_of(Shown const& shown) {
  return {.name = shown.name, .role = shown.role, .colour = shown.colour, .points = {}};
}

pictures::Panel gain_panel(std::vector<Shown> const& settings, pictures::Axis const& x, double T,
                           Language language) {
  pictures::Panel panel;
  panel.y = {.quantity = say(language, labels::gain), .unit = "dB", .low = lowest_gain, .high = highest_gain};
  for (auto const& shown : settings) {
    auto curve = curve_of(shown);
    for (int i = 0; i <= frequencies; ++i) {
      double const f = x.low * std::pow(x.high / x.low, static_cast<double>(i) / frequencies);
      double const gain = std::abs(tuning::gain(shown.response, 2 * std::numbers::pi * f * T));
      constexpr double bel = 20;
      curve.points.push_back({.x = f, .y = std::max(lowest_gain, bel * std::log10(std::max(gain, 1e-12)))});
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

pictures::Panel step_panel(std::vector<Shown> const& settings, double T, Language language) {
  pictures::Panel panel;
  panel.y = {.quantity = say(language, says::step), .low = -0.1, .high = 1.3};
  std::size_t longest = 0;
  for (auto const& shown : settings) longest = std::max(longest, shown.response.taps.size());
  double const milli = T * 1e3;
  panel.x = pictures::Axis{.quantity = say(language, labels::time),
                           .unit = "ms",
                           .low = 0,
                           .high = milli * static_cast<double>(longest + 2)};
  for (auto const& shown : settings) {
    auto curve = curve_of(shown);
    double step = 0;
    for (std::size_t n = 0; n < longest + 2; ++n) {
      if (n < shown.response.taps.size()) step += shown.response.taps[n];
      curve.points.push_back({.x = milli * static_cast<double>(n), .y = step});
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

}  // namespace

pictures::Figure suggest_figure(Suggested const& suggested, Language language) {
  if (suggested.suggestion() == nullptr) throw Failure({says::nothing_to_draw});
  auto const& suggestion = *suggested.suggestion();
  auto const settings = shown_settings(suggestion, language);
  double const T = suggestion.cycle_time.seconds();
  double highest = 0;
  pictures::Figure figure;
  figure.title = say(language, says::figure_title, {{"axis", suggestion.axis}});
  for (auto const& resonance : suggestion.task.resonances) {
    constexpr int digits = 4;
    figure.marks.push_back({.at = resonance.frequency,
                            .label = format_rounded(resonance.frequency, digits).in(language) + " Hz"});
    highest = std::max(highest, resonance.frequency);
  }
  for (auto const& shown : settings) {
    figure.description += (figure.description.empty() ? "" : "; ") +
                          say(language, says::described,
                              {{"setting", shown.name},
                               {"chain", name_of(shown.setting->chain)},
                               {"vibration", format_fixed(shown.setting->figures.vibration * 100, 1)},
                               {"delay", format_fixed(shown.setting->figures.delay * T * 1e3, 1)}});
  }
  figure.x = {.quantity = say(language, labels::frequency),
              .unit = "Hz",
              .scale = pictures::Scale::logarithmic,
              .low = 1,
              .high = std::min(5 * highest, suggestion.cycle_time.nyquist().value)};
  figure.panels.push_back(gain_panel(settings, figure.x, T, language));
  figure.panels.push_back(step_panel(settings, T, language));
  return figure;
}

}  // namespace axisc
