#include "analysis/motion/contour/contour_predictions.hpp"
#include "axisc/answers/figures/contour_cases.hpp"
#include "axisc/answers/figures/polar_panel.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/ticks.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence circle_title{"Circle of radius {radius} mm, plane {plane}, deviation × {factor}",
                                "Kreis mit Radius {radius} mm, Ebene {plane}, Abweichung × {factor}"};
constexpr Sentence circle_case{"{case}: {deviation} µm", "{case}: {deviation} µm"};
constexpr Sentence circle_programmed{"programmed radius", "programmierter Radius"};
constexpr Sentence circle_ring{"{deviation} µm", "{deviation} µm"};
constexpr Sentence circle_none{"The filtered path lies on the circle: nothing deviates.",
                               "Die gefilterte Bahn liegt auf dem Kreis: nichts weicht ab."};

}  // namespace axisc::says

namespace axisc {

namespace {

std::vector<pictures::Point> closed(std::vector<motion::Point> const& path) {
  std::vector<pictures::Point> points;
  points.reserve(path.size() + 1);
  for (auto const& point : path) points.push_back({.x = point[0], .y = point[1]});
  points.push_back(points.front());
  return points;
}

}  // namespace

pictures::Figure circle_figure(ContourSubject const& subject, ContourRequest const& wanted) {
  double const radius = wanted.radius_mm * motion::units_per_mm;
  auto const deviation_of = [radius](std::vector<motion::ChainAnswer> const& plane, double velocity) {
    return motion::predict_circle(plane, velocity, radius).deviation;
  };
  auto const curves = contour_curves(subject, wanted, deviation_of);
  pictures::Figure figure;
  std::vector<double> deviations;
  deviations.reserve(curves.size());
  for (auto const& curve : curves) deviations.push_back(deviation_of(curve.answers, curve.velocity));
  double const largest = *std::max_element(deviations.begin(), deviations.end());
  constexpr double smallest_seen = 1e-3;
  bool const deviates = largest > smallest_seen;
  PolarPanel panel(radius, deviates ? largest : 0);
  figure.title = subject.say(says::circle_title, {{"radius", format_rounded(wanted.radius_mm, 4)},
                                                  {"plane", plane_name(subject, curves.back())},
                                                  {"factor", format_rounded(panel.factor(), 4)}});
  for (std::size_t i = 0; i < curves.size(); ++i) {
    figure.description +=
        (i == 0 ? "" : "; ") +
        subject.say(says::circle_case, {{"case", curves[i].name}, {"deviation", micrometres(deviations[i])}});
  }
  figure.table = deviation_table(subject, curves, deviations);
  if (!deviates) {
    figure.nothing = subject.say(says::circle_none);
    return figure;
  }
  panel.add_ring(0, subject.say(says::circle_programmed));
  double const step = pictures::round_below(largest * 0.9 / motion::units_per_um) * motion::units_per_um;
  for (double const sign : {-1.0, 1.0}) {
    panel.add_ring(
        sign * step, {},
        subject.say(says::circle_ring, {{"deviation", (sign > 0 ? "+" : "-") + micrometres(step)}}),
        sign < 0 ? PolarPanel::Words::below : PolarPanel::Words::above);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto const& curve = curves[i];
    panel.add({.name = subject.say(says::circle_case,
                                   {{"case", curve.name}, {"deviation", micrometres(deviations[i])}}),
               .role = curve.role,
               .colour = curve.colour},
              closed(motion::circle_path(curve.answers[0], curve.answers[1], curve.velocity, radius,
                                         polar_directions)));
  }
  figure.panels.push_back(std::move(panel).take());
  return figure;
}

}  // namespace axisc
