#include "axisc/answers/figures/plant_figure.hpp"

#include "analysis/motion/point.hpp"
#include "analysis/motion/spectrum.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence plant_title{
    "Axis {axis} in its position loop: {distance} mm there and back at {feed} mm/min",
    "Achse {axis} im Lageregelkreis: {distance} mm hin und zurück mit {feed} mm/min"};
constexpr Sentence plant_error{"following error", "Schleppabstand"};
constexpr Sentence plant_acceleration{"load", "Last"};
constexpr Sentence plant_travelling{"travelling", "Verfahren"};
constexpr Sentence plant_resting{"at rest", "Stillstand"};
constexpr Sentence plant_without{"without Improved Position Control", "ohne optimierte Lageregelung"};
constexpr Sentence plant_with{"with Improved Position Control", "mit optimierter Lageregelung"};
constexpr Sentence plant_alone{"load", "Last"};
constexpr Sentence plant_oscillation{"oscillation [Hz]", "Schwingung [Hz]"};
constexpr Sentence plant_amplitude_without{"without [m/s²]", "ohne [m/s²]"};
constexpr Sentence plant_amplitude_with{"with [m/s²]", "mit [m/s²]"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double spectrum_step = 0.25;

class PlantFigure {
 public:
  PlantFigure(PlantRun const& run, Language language) : run_(run), language_(language) {}

  pictures::Figure make() {
    auto const& figures = run_.figures;
    pictures::Figure figure;
    figure.title =
        say(says::plant_title, {{"axis", figures.axis},
                                {"distance", format_rounded(figures.distance_mm, pictures::shown_digits)},
                                {"feed", format_rounded(figures.feed_mm_per_min, pictures::shown_digits)}});
    add_table(figure);
    auto const cycles = std::max(run_.without.cycles.size(), run_.with.cycles.size());
    figure.x = {.quantity = say(labels::time),
                .unit = "s",
                .low = 0,
                .high = std::max(1.0, static_cast<double>(cycles)) * run_.cycle_seconds};
    figure.panels.push_back(over_time(say(says::plant_error), "µm", [](motion::LoopCycle const& cycle) {
      return (cycle.setpoint - cycle.load_position) / motion::units_per_um;
    }));
    figure.panels.push_back(
        over_time(say(says::plant_acceleration), "m/s²",
                  [](motion::LoopCycle const& cycle) { return cycle.load_acceleration; }));
    figure.panels.push_back(spectrum(says::plant_travelling, motion::MovePhase::travel));
    figure.panels.push_back(spectrum(says::plant_resting, motion::MovePhase::rest));
    return figure;
  }

 private:
  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language_);
  }

  void add_table(pictures::Figure& figure) const {
    figure.table.header = {say(labels::phase), say(says::plant_oscillation),
                           say(says::plant_amplitude_without), say(says::plant_amplitude_with)};
    for (auto const& found : run_.figures.oscillations) {
      bool const travels = found.phase == motion::MovePhase::travel;
      figure.table.rows.push_back(
          {say(travels ? SentenceRef(says::plant_travelling) : SentenceRef(says::plant_resting)),
           format_rounded(found.without.frequency, pictures::shown_digits).in(language_),
           format_rounded(found.without.amplitude, pictures::shown_digits).in(language_),
           found.with ? format_rounded(*found.with, pictures::shown_digits).in(language_) : "-"});
      auto const& row = figure.table.rows.back();
      figure.description += (figure.description.empty() ? "" : "; ") + row[0] + ": " + row[1] + " Hz, " +
                            row[2] + " → " + row[3] + " m/s²";
    }
  }

  /// Without the function dashed below, with it bold on top; alone where the axis has none.
  [[nodiscard]] std::vector<pictures::Curve> curves() const {
    if (!run_.figures.has_function) return {{.name = say(says::plant_alone)}};
    return {{.name = say(says::plant_without), .role = pictures::Role::before, .colour = 1},
            {.name = say(says::plant_with), .role = pictures::Role::whole, .colour = 0}};
  }

  [[nodiscard]] motion::LoopRecord const& record(pictures::Curve const& curve) const {
    return curve.role == pictures::Role::before ? run_.without : run_.with;
  }

  static void fit(pictures::Axis& y, std::vector<pictures::Curve> const& curves, bool from_zero) {
    double low = 0;
    double high = 0;
    for (auto const& curve : curves) {
      for (auto const& point : curve.points) {
        if (!std::isfinite(point.y)) continue;
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
    }
    double const span = std::max(high - low, 1e-9);
    y.low = from_zero ? 0 : low - span * 0.06;
    y.high = high + span * 0.06;
  }

  template <class Quantity>
  [[nodiscard]] pictures::Panel over_time(std::string name, std::string unit, Quantity quantity) const {
    pictures::Panel panel{.y = {.quantity = std::move(name), .unit = std::move(unit)}, .curves = curves()};
    for (auto& curve : panel.curves) {
      double time = 0;
      for (auto const& cycle : record(curve).cycles) {
        curve.points.push_back({.x = time, .y = quantity(cycle)});
        time += run_.cycle_seconds;
      }
    }
    fit(panel.y, panel.curves, false);
    return panel;
  }

  [[nodiscard]] pictures::Panel spectrum(SentenceRef phase_name, motion::MovePhase phase) const {
    auto const [lowest, highest] = oscillation_band(run_.cycle_seconds);
    pictures::Panel panel{.y = {.quantity = say(phase_name), .unit = "m/s²"}, .curves = curves()};
    panel.x =
        pictures::Axis{.quantity = say(labels::frequency), .unit = "Hz", .low = lowest, .high = highest};
    for (auto& curve : panel.curves) {
      auto const accelerations = load_accelerations(record(curve), phase, false);
      auto const points = accelerations.empty() ? 0 : static_cast<int>((highest - lowest) / spectrum_step);
      std::vector<double> frequencies;
      for (int i = 0; i <= points && points > 0; ++i) frequencies.push_back(lowest + i * spectrum_step);
      auto const amplitudes = motion::amplitudes_at(accelerations, run_.cycle_seconds, frequencies);
      for (std::size_t i = 0; i < frequencies.size(); ++i) {
        curve.points.push_back({.x = frequencies[i], .y = amplitudes[i]});
      }
    }
    fit(panel.y, panel.curves, true);
    return panel;
  }

  PlantRun const& run_;
  Language language_;
};

}  // namespace

pictures::Figure plant_figure(PlantRun const& run, Language language) {
  return PlantFigure(run, language).make();
}

}  // namespace axisc
