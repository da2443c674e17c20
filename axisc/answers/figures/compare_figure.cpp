#include "axisc/answers/figures/compare_figure.hpp"

#include "analysis/comparison/overlay.hpp"
#include "analysis/motion/spectrum.hpp"
#include "axisc/answers/comparison/compare_answer.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence compare_title{"Axis {axis}: the control beside axisc",
                                 "Achse {axis}: die Steuerung neben axisc"};
constexpr Sentence compare_position{"position", "Position"};
constexpr Sentence compare_difference{"recorded - computed", "aufgezeichnet - berechnet"};
constexpr Sentence compare_setpoint{"setpoint", "Sollwert"};
constexpr Sentence compare_recorded{"recorded", "aufgezeichnet"};
constexpr Sentence compare_listed{"what axisc computes", "was axisc rechnet"};
constexpr Sentence compare_of{"computed by", "berechnet nach"};
constexpr Sentence compare_largest{"largest deviation [{unit}]", "größte Abweichung [{unit}]"};
constexpr Sentence compare_rms{"rms [{unit}]", "Effektivwert [{unit}]"};
constexpr Sentence compare_delay{"delay [cycles]", "Verzögerung [Zyklen]"};
constexpr Sentence compare_allowed{"rounding of the recording", "Runden der Aufzeichnung"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int residual_digits = 3;
constexpr std::size_t shown_cycles = 2000;
constexpr int spectrum_points = 400;

class CompareFigure {
 public:
  CompareFigure(RecordedAxis const& recorded, double cycle_seconds, Language language)
      : recorded_(recorded), cycle_seconds_(cycle_seconds), language_(language) {
    auto const& result = recorded.result;
    add(says::compare_listed, recorded.readings.front(), result.listed);
    if (result.verdict == comparison::Verdict::different && !result.fitting.empty()) {
      auto const& best = result.fitting.front();
      computed_.push_back(
          {reading_words(best.reading).in(language_), best.residual, overlay(best.reading, best.residual)});
    }
  }

  pictures::Figure make(std::string const& axis) {
    pictures::Figure figure;
    figure.title = say(says::compare_title, {{"axis", axis}});
    add_table(figure);
    auto const& shown = computed_.front().overlay;
    double const begin = static_cast<double>(shown.first) * cycle_seconds_;
    figure.x = {.quantity = say(labels::time),
                .unit = "s",
                .low = begin,
                .high = begin + std::max(1.0, static_cast<double>(shown.recorded.size())) * cycle_seconds_};
    figure.panels = {positions(begin), differences(begin), spectra()};
    return figure;
  }

 private:
  struct Computed {
    std::string name;
    comparison::Residual residual;
    comparison::Overlay overlay;
  };

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language_);
  }
  [[nodiscard]] comparison::Overlay overlay(comparison::Reading const& reading,
                                            comparison::Residual const& residual) const {
    return comparison::overlay(recorded_.columns.recording, reading.chain, residual.delay_cycles,
                               shown_cycles);
  }
  void add(SentenceRef name, comparison::Reading const& reading, comparison::Residual const& residual) {
    computed_.push_back({say(name), residual, overlay(reading, residual)});
  }
  [[nodiscard]] std::string length(double value) const {
    return format_rounded(value * recorded_.thousandths, residual_digits).in(language_);
  }

  void add_table(pictures::Figure& figure) const {
    std::vector<Argument> const unit{{"unit", recorded_.unit()}};
    figure.table.header = {say(says::compare_of), say(says::compare_largest, unit),
                           say(says::compare_rms, unit), say(says::compare_delay)};
    for (auto const& [name, residual, shown] : computed_) {
      figure.table.rows.push_back({name, length(residual.largest), length(residual.rms),
                                   format_rounded(residual.delay_cycles, residual_digits).in(language_)});
      figure.description += (figure.description.empty() ? "" : "; ") + name + ": " +
                            length(residual.largest) + " " + recorded_.unit();
    }
    figure.table.rows.push_back({say(says::compare_allowed), "-", length(recorded_.result.allowed_rms), "-"});
  }

  [[nodiscard]] static pictures::Role role_of(std::size_t index) {
    return index == 0 ? pictures::Role::before : pictures::Role::whole;
  }
  [[nodiscard]] double scale() const { return recorded_.thousandths; }

  static void fit(pictures::Axis& y, std::vector<pictures::Curve> const& curves, bool from_zero) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (auto const& curve : curves) {
      for (auto const& point : curve.points) {
        if (!std::isfinite(point.y)) continue;
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
    }
    if (!(low <= high)) low = high = 0;
    constexpr double border = 0.06;
    double const span = std::max(high - low, 1e-6);
    y.low = from_zero ? 0 : low - span * border;
    y.high = high + span * border;
  }

  [[nodiscard]] pictures::Curve over_time(std::string name, pictures::Role role, std::size_t colour,
                                          double begin, std::vector<double> const& values,
                                          double factor) const {
    pictures::Curve curve{.name = std::move(name), .role = role, .colour = colour};
    for (std::size_t i = 0; i < values.size(); ++i) {
      curve.points.push_back({.x = begin + static_cast<double>(i) * cycle_seconds_, .y = values[i] * factor});
    }
    return curve;
  }

  /// In mm, or degrees.
  [[nodiscard]] pictures::Panel positions(double begin) const {
    constexpr double thousand = 1000;
    double const factor = scale() / thousand;
    auto const& shown = computed_.front().overlay;
    pictures::Panel panel{
        .y = {.quantity = say(says::compare_position), .unit = recorded_.is_rotary ? "°" : "mm"}};
    panel.curves.push_back(
        over_time(say(says::compare_setpoint), pictures::Role::guide, 0, begin, shown.input, factor));
    panel.curves.push_back(
        over_time(say(says::compare_recorded), pictures::Role::measured, 2, begin, shown.recorded, factor));
    for (std::size_t i = 0; i < computed_.size(); ++i) {
      panel.curves.push_back(
          over_time(computed_[i].name, role_of(i), i, begin, computed_[i].overlay.computed, factor));
    }
    fit(panel.y, panel.curves, false);
    return panel;
  }

  [[nodiscard]] static std::vector<double> difference(comparison::Overlay const& shown) {
    std::vector<double> values;
    for (std::size_t i = 0; i < shown.recorded.size(); ++i) {
      values.push_back(shown.recorded[i] - shown.computed[i]);
    }
    return values;
  }

  [[nodiscard]] pictures::Panel differences(double begin) const {
    pictures::Panel panel{.y = {.quantity = say(says::compare_difference), .unit = recorded_.unit()}};
    for (std::size_t i = 0; i < computed_.size(); ++i) {
      panel.curves.push_back(
          over_time(computed_[i].name, role_of(i), i, begin, difference(computed_[i].overlay), scale()));
    }
    fit(panel.y, panel.curves, false);
    return panel;
  }

  [[nodiscard]] pictures::Panel spectra() const {
    double const nyquist = 0.5 / cycle_seconds_;
    pictures::Panel panel{.y = {.quantity = say(labels::difference), .unit = recorded_.unit()}};
    panel.x = pictures::Axis{.quantity = say(labels::frequency), .unit = "Hz", .low = 0, .high = nyquist};
    for (std::size_t i = 0; i < computed_.size(); ++i) {
      auto values = difference(computed_[i].overlay);
      std::erase_if(values, [](double value) { return !std::isfinite(value); });
      pictures::Curve curve{.name = computed_[i].name, .role = role_of(i), .colour = i};
      std::vector<double> frequencies;
      for (int k = 1; k < spectrum_points && !values.empty(); ++k) {
        frequencies.push_back(nyquist * k / spectrum_points);
      }
      auto const amplitudes = motion::amplitudes_at(values, cycle_seconds_, frequencies);
      for (std::size_t k = 0; k < frequencies.size(); ++k) {
        curve.points.push_back({.x = frequencies[k], .y = amplitudes[k] * scale()});
      }
      panel.curves.push_back(std::move(curve));
    }
    fit(panel.y, panel.curves, true);
    return panel;
  }

  RecordedAxis const& recorded_;
  double cycle_seconds_;
  Language language_;
  std::vector<Computed> computed_;
};

}  // namespace

pictures::Figure compare_figure(RecordedAxis const& recorded, std::string const& axis, double cycle_seconds,
                                Language language) {
  return CompareFigure(recorded, cycle_seconds, language).make(axis);
}

}  // namespace axisc
