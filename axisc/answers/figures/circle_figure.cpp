#include "analysis/motion/contour/contour_predictions.hpp"
#include "axisc/answers/figures/contour_cases.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

constexpr double circle_height = 460;
/// In units of the drawn radius: how far the largest deviation is drawn from it.
constexpr double drawn_deviation = 0.3;
constexpr std::size_t directions = 720;

/// 1, 2 or 5 times a power of ten, not above `value`.
double round_below(double value) {
  double const power = std::pow(10.0, std::floor(std::log10(value)));
  for (double const step : {5.0, 2.0}) {
    if (value >= step * power) return step * power;
  }
  return power;
}

pictures::Curve ring(double radius) {
  pictures::Curve curve{.name = "", .role = pictures::Role::guide, .colour = 0, .points = {}};
  for (std::size_t i = 0; i <= directions; ++i) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(i) / directions;
    curve.points.push_back({.x = radius * std::cos(angle), .y = radius * std::sin(angle)});
  }
  return curve;
}

/// Radius 1 is the programmed one; deviations are `factor` times as large.
pictures::Curve polar(std::vector<motion::Point> const& path, double radius, double factor) {
  pictures::Curve curve;
  for (std::size_t i = 0; i <= path.size(); ++i) {
    auto const& point = path[i % path.size()];
    double const distance = std::hypot(point[0], point[1]);
    double const shown = 1 + (distance - radius) / radius * factor;
    double const scale = distance > 0 ? shown / distance : 0;
    curve.points.push_back({.x = point[0] * scale, .y = point[1] * scale});
  }
  return curve;
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
  double const factor = deviates ? std::max(1.0, round_below(drawn_deviation * radius / largest)) : 1;
  figure.title = subject.say(says::circle_title, {{"radius", format_rounded(wanted.radius_mm, 4)},
                                                  {"plane", plane_name(subject, curves.back())},
                                                  {"factor", format_rounded(factor, 4)}});
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
  double const outside = 1 + drawn_deviation * 1.1;
  figure.x = {.low = -outside, .high = outside};
  pictures::Panel panel{
      .y = {.low = -outside, .high = outside}, .curves = {}, .height = circle_height, .is_bare = true};
  pictures::make_equal(figure.x, panel.y, panel.height);
  auto nominal = ring(1);
  nominal.name = subject.say(says::circle_programmed);
  panel.curves.push_back(std::move(nominal));
  double const step = round_below(largest * 0.9 / motion::units_per_um) * motion::units_per_um;
  for (double const sign : {-1.0, 1.0}) {
    double const shown = 1 + sign * step / radius * factor;
    panel.curves.push_back(ring(shown));
    panel.labels.push_back({.at = {.x = outside + 0.05, .y = sign * 0.4},
                            .words = subject.say(says::circle_ring, {{"deviation", (sign > 0 ? "+" : "-") +
                                                                                       micrometres(step)}})});
    // A line from the words to the ring.
    panel.curves.push_back({.name = "",
                            .role = pictures::Role::guide,
                            .colour = 0,
                            .points = {{.x = std::sqrt(shown * shown - 0.16), .y = sign * 0.4},
                                       {.x = outside + 0.02, .y = sign * 0.4}}});
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto const& curve = curves[i];
    auto drawn =
        polar(motion::circle_path(curve.answers[0], curve.answers[1], curve.velocity, radius, directions),
              radius, factor);
    drawn.name =
        subject.say(says::circle_case, {{"case", curve.name}, {"deviation", micrometres(deviations[i])}});
    drawn.role = curve.role;
    drawn.colour = curve.colour;
    panel.curves.push_back(std::move(drawn));
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace axisc
