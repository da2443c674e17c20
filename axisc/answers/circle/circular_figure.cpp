#include "axisc/answers/circle/circular_figure.hpp"

#include "axisc/answers/circle/circle_answer.hpp"
#include "axisc/answers/figures/polar_panel.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::says {

constexpr Sentence circular_title{"Circular test {circle}, deviations × {factor}",
                                  "Kreisformtest {circle}, Abweichungen × {factor}"};
constexpr Sentence several_circles{"Circular test", "Kreisformtest"};
constexpr Sentence magnified{"{circle}, deviations × {factor}", "{circle}, Abweichungen × {factor}"};
constexpr Sentence described{"{circle}: G {deviation} µm", "{circle}: G {deviation} µm"};
constexpr Sentence direction{"{u} → {v}", "{u} → {v}"};
constexpr Sentence predicted_direction{"predicted, {u} → {v}", "vorhergesagt, {u} → {v}"};
constexpr Sentence programmed{"programmed radius", "programmierter Radius"};
constexpr Sentence tolerance{"tolerance", "Toleranz"};
constexpr Sentence bars{"what each cause adds", "was jede Ursache beiträgt"};

}  // namespace axisc::says

namespace axisc {

namespace {

using circle::Sense;

constexpr int directions = 720;
/// Points of a recorded curve: of more, those with the extremes of each stretch.
constexpr std::size_t most_stretches = 1800;
constexpr int digits = 3;

std::vector<pictures::Point> predicted_path(circle::PredictedCircle const& circle, Sense sense) {
  std::vector<pictures::Point> points;
  for (int i = 0; i <= directions; ++i) {
    double const angle = 2 * std::numbers::pi * i / directions;
    double const distance = circle.radius + circle.deviation_at(angle, sense);
    points.push_back({.x = distance * std::cos(angle), .y = distance * std::sin(angle)});
  }
  return points;
}

std::vector<pictures::Point> recorded_path(circle::Turn const& turn) {
  std::vector<pictures::Point> points;
  auto const& samples = turn.samples;
  std::size_t const stretch = samples.size() / most_stretches + 1;
  auto const nearer = [](circle::Sample const& a, circle::Sample const& b) {
    return std::hypot(a.u, a.v) < std::hypot(b.u, b.v);
  };
  for (std::size_t i = 0; i < samples.size(); i += stretch) {
    auto const begin = samples.begin() + static_cast<std::ptrdiff_t>(i);
    auto const end = samples.begin() + static_cast<std::ptrdiff_t>(std::min(i + stretch, samples.size()));
    auto [first, second] = std::minmax_element(begin, end, nearer);
    if (second < first) std::swap(first, second);
    points.push_back({.x = first->u, .y = first->v});
    if (first != second) points.push_back({.x = second->u, .y = second->v});
  }
  return points;
}

double largest_deviation(CircleCase const& one, std::optional<double> tolerance) {
  double largest = std::max(std::abs(one.deviations.radial_max), std::abs(one.deviations.radial_min));
  if (one.recorded) {
    auto const& recorded = one.recorded->deviations;
    largest = std::max({largest, std::abs(recorded.radial_max), std::abs(recorded.radial_min)});
  }
  return std::max(largest, tolerance.value_or(0) / 2);
}

class CircularFigure {
 public:
  CircularFigure(CircularTest const& test, Language language) : test_(test), language_(language) {}

  pictures::Figure make() {
    bool const is_one = test_.cases.size() == 1;
    figure_.title = say(says::several_circles);
    for (auto const& one : test_.cases) {
      auto const title = presentation::text_of(circle_title(one), language_);
      figure_.description +=
          (figure_.description.empty() ? "" : "; ") +
          say(says::described, {{"circle", title}, {"deviation", number(one.deviation())}});
      add_circle(one, title, is_one);
      add_bars(one);
    }
    return std::move(figure_);
  }

 private:
  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language_);
  }
  [[nodiscard]] static Wording number(double value) { return format_rounded(value, digits); }

  void add_circle(CircleCase const& one, std::string const& title, bool is_one) {
    PolarPanel panel(one.predicted.radius, largest_deviation(one, test_.tolerance_um));
    auto const factor = format_rounded(panel.factor(), digits);
    if (is_one) figure_.title = say(says::circular_title, {{"circle", title}, {"factor", factor}});
    panel.add_ring(0, say(says::programmed));
    add_rings(panel, one);
    auto const style = [&](Sense sense, bool is_predicted) {
      bool const is_first = sense == Sense::counterclockwise;
      return pictures::Curve{
          .name = say(is_predicted ? says::predicted_direction : says::direction,
                      {{"u", one.axes.at(is_first ? 0 : 1)}, {"v", one.axes.at(is_first ? 1 : 0)}}),
          .role = is_predicted ? pictures::Role::before : pictures::Role::whole,
          .colour = is_first ? std::size_t{0} : std::size_t{1},
          .points = {}};
    };
    for (auto const sense : {Sense::counterclockwise, Sense::clockwise}) {
      panel.add(style(sense, one.recorded.has_value()), predicted_path(one.predicted, sense));
    }
    if (one.recorded) {
      for (auto const& turn : one.recorded->turns) panel.add(style(turn.sense, false), recorded_path(turn));
    }
    auto drawn = std::move(panel).take();
    if (!is_one) {
      drawn.labels.push_back({.at = {.x = drawn.x->low, .y = drawn.y.high * 0.95},
                              .words = say(says::magnified, {{"circle", title}, {"factor", factor}})});
    }
    figure_.panels.push_back(std::move(drawn));
  }

  /// The tolerance, or without one how much a ring is.
  void add_rings(PolarPanel& panel, CircleCase const& one) const {
    auto const& figures = one.recorded ? one.recorded->deviations : one.deviations;
    double const mean = (figures.radial_max + figures.radial_min) / 2;
    double const largest = largest_deviation(one, {});
    if (!test_.tolerance_um && !(largest > 0)) return;
    double const step = test_.tolerance_um ? *test_.tolerance_um / 2 : pictures::round_below(largest * 0.9);
    for (double const sign : {-1.0, 1.0}) {
      double const at = test_.tolerance_um ? mean + sign * step : sign * step;
      panel.add_ring(at, test_.tolerance_um ? say(says::tolerance) : std::string(),
                     (at > 0 ? "+" : "") + number(at).in(language_) + " µm",
                     sign < 0 ? PolarPanel::Words::below : PolarPanel::Words::above);
    }
  }

  void add_bars(CircleCase const& one) {
    auto const causes = causes_by_size(one);
    if (causes.empty() || !(causes.front().size_um > 0)) return;
    constexpr double row_height = 24;
    auto const rows = static_cast<double>(causes.size());
    pictures::Panel panel;
    panel.height = row_height * rows;
    panel.y = {.low = -0.5, .high = rows - 0.5};
    // The words at the ends of the bars have room.
    panel.x = pictures::Axis{
        .quantity = say(says::bars), .unit = "µm", .low = 0, .high = causes.front().size_um * 1.5};
    for (std::size_t i = 0; i < causes.size(); ++i) {
      double const y = rows - 1 - static_cast<double>(i);
      double const size = causes[i].size_um;
      panel.y.ticks.push_back(y);
      panel.y.names.emplace_back();
      panel.curves.push_back(
          {.name = {}, .role = pictures::Role::bar, .colour = 2, .points = {{0, y}, {size, y}}});
      panel.labels.push_back(
          {.at = {.x = size + panel.x->high * 0.01, .y = y - 0.17},
           .words = presentation::text_of(causes[i].name, language_) + ": " +
                    presentation::quantity_text(presentation::fixed(size, presentation::Unit::micrometre, 2),
                                                language_)});
    }
    figure_.panels.push_back(std::move(panel));
  }

  CircularTest const& test_;
  Language language_;
  pictures::Figure figure_;
};

}  // namespace

pictures::Figure circular_figure(CircularTest const& test, Language language) {
  return CircularFigure(test, language).make();
}

}  // namespace axisc
