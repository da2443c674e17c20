#include "analysis/motion/contour/contour_predictions.hpp"
#include "axisc/answers/figures/contour_cases.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/clipping.hpp"
#include "presentation/pictures/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::says {

constexpr Sentence corner_title{"Corner of {angle}°, plane {plane}", "Ecke von {angle}°, Ebene {plane}"};
constexpr Sentence corner_programmed{"programmed", "programmiert"};
constexpr Sentence corner_case{"{case}: {deviation} µm", "{case}: {deviation} µm"};
constexpr Sentence corner_none{"The filtered path runs through the corner: nothing deviates.",
                               "Die gefilterte Bahn läuft durch die Ecke: nichts weicht ab."};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double corner_height = 420;

pictures::Point in_um(motion::Point const& point) {
  return {.x = point[0] / motion::units_per_um, .y = point[1] / motion::units_per_um};
}

/// Both legs, longer than the picture is wide.
pictures::Curve programmed(ContourSubject const& subject, double turn, double length) {
  return {.name = subject.say(says::corner_programmed),
          .role = pictures::Role::guide,
          .colour = 0,
          .points = {{.x = -length, .y = 0},
                     {.x = 0, .y = 0},
                     {.x = length * std::cos(turn), .y = length * std::sin(turn)}}};
}

/// From the corner to the nearest point of the path.
pictures::Curve dimension(std::vector<pictures::Point> const& path, pictures::Role role, std::size_t colour) {
  pictures::Point nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    auto const& a = path[i - 1];
    double const dx = path[i].x - a.x;
    double const dy = path[i].y - a.y;
    double const squared = dx * dx + dy * dy;
    double const share = squared > 0 ? std::clamp(-(a.x * dx + a.y * dy) / squared, 0.0, 1.0) : 0;
    pictures::Point const here{.x = a.x + share * dx, .y = a.y + share * dy};
    if (std::hypot(here.x, here.y) >= least) continue;
    least = std::hypot(here.x, here.y);
    nearest = here;
  }
  return {.name = "",
          .role = role == pictures::Role::before ? role : pictures::Role::part,
          .colour = colour,
          .points = {{.x = 0, .y = 0}, nearest}};
}

}  // namespace

pictures::Figure corner_figure(ContourSubject const& subject, ContourRequest const& wanted) {
  double const turn = wanted.angle_deg * std::numbers::pi / 180;
  auto const deviation_of = [turn](std::vector<motion::ChainAnswer> const& plane, double velocity) {
    return motion::predict_corner(plane, velocity, turn).deviation;
  };
  auto const curves = contour_curves(subject, wanted, deviation_of);
  pictures::Figure figure;
  figure.title = subject.say(says::corner_title, {{"angle", format_rounded(wanted.angle_deg, 4)},
                                                  {"plane", plane_name(subject, curves.back())}});
  std::vector<double> deviations;
  for (auto const& curve : curves) {
    deviations.push_back(deviation_of(curve.answers, curve.velocity));
    figure.description +=
        (figure.description.empty() ? "" : "; ") +
        subject.say(says::corner_case, {{"case", curve.name}, {"deviation", micrometres(deviations.back())}});
  }
  figure.table = deviation_table(subject, curves, deviations);
  double const largest = *std::max_element(deviations.begin(), deviations.end()) / motion::units_per_um;
  constexpr double smallest_seen = 1e-4;
  if (!(largest > smallest_seen)) {
    figure.nothing = subject.say(says::corner_none);
    return figure;
  }
  auto const& last = curves.back();
  figure.x = {.quantity = subject.axes[last.plane.first], .unit = "µm", .low = -4 * largest, .high = largest};
  pictures::Panel panel{
      .y = {.quantity = subject.axes[last.plane.second], .unit = "µm", .low = -largest, .high = 4 * largest},
      .curves = {},
      .height = corner_height};
  if (wanted.angle_deg < 90) figure.x.high = 4 * largest;
  pictures::make_equal(figure.x, panel.y, panel.height);
  panel.curves.push_back(programmed(subject, turn, 100 * largest));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto const& curve = curves[i];
    pictures::Curve drawn{.name = subject.say(says::corner_case, {{"case", curve.name},
                                                                  {"deviation", micrometres(deviations[i])}}),
                          .role = curve.role,
                          .colour = curve.colour,
                          .points = {}};
    for (auto const& point : motion::corner_path(curve.answers[0], curve.answers[1], curve.velocity, turn)) {
      drawn.points.push_back(in_um(point));
    }
    panel.curves.push_back(dimension(drawn.points, curve.role, curve.colour));
    panel.curves.push_back(std::move(drawn));
  }
  for (auto& curve : panel.curves) curve.points = pictures::clipped(curve.points, figure.x, panel.y);
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace axisc
