#include "axisc/answers/figures/path_figure.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::says {

constexpr Sentence path_title{"Path of {program}, plane {x}/{y}", "Bahn von {program}, Ebene {x}/{y}"};
constexpr Sentence path_described{"{time} s, largest contour deviation {deviation} µm in line {line}",
                                  "{time} s, größte Bahnabweichung {deviation} µm in Zeile {line}"};
constexpr Sentence path_programmed{"programmed", "programmiert"};
constexpr Sentence path_up_to{"deviation up to {deviation} µm", "Abweichung bis {deviation} µm"};
constexpr Sentence path_velocity_of{"path velocity", "Bahngeschwindigkeit"};
constexpr Sentence path_acceleration{"acceleration", "Beschleunigung"};
constexpr Sentence path_mark{"line {line}: {deviation} µm", "Zeile {line}: {deviation} µm"};
constexpr Sentence path_tolerance{"tolerance", "Toleranz"};
constexpr Sentence path_nothing{"The program moves nothing.", "Das Programm bewegt nichts."};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t classes = 4;
constexpr std::size_t most_marks = 5;
constexpr double plane_height = 420;

class PathFigure {
 public:
  PathFigure(PathRecorder const& recorder, PathPlot const& plot, Language language)
      : recorder_(recorder), plot_(plot), language_(language), samples_(recorder.samples()) {}

  pictures::Figure make() {
    pictures::Figure figure;
    figure.title = say(says::path_title,
                       {{"program", plot_.program}, {"x", plot_.axes.first}, {"y", plot_.axes.second}});
    if (samples_.size() < 2) {
      figure.nothing = say(says::path_nothing);
      return figure;
    }
    auto const worst = recorder_.worst_blocks(most_marks);
    describe(figure, worst);
    figure.x = {.quantity = say(labels::time), .unit = "s", .low = 0, .high = time(samples_.back())};
    figure.panels.push_back(plane(worst));
    figure.panels.push_back(deviations());
    figure.panels.push_back(velocities());
    figure.panels.push_back(accelerations());
    return figure;
  }

 private:
  using Sample = PathRecorder::Sample;

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language_);
  }

  [[nodiscard]] std::string rounded(double value) const {
    return format_rounded(value, pictures::shown_digits).in(language_);
  }

  [[nodiscard]] double time(Sample const& sample) const { return (sample.cycle + 1) * plot_.cycle_seconds; }

  void describe(pictures::Figure& figure, std::vector<PathRecorder::Block> const& worst) const {
    figure.table.header = {say(labels::line), say(labels::contour_deviation)};
    for (auto const& block : worst) {
      figure.table.rows.push_back({std::to_string(block.line), rounded(block.deviation)});
    }
    auto const line = worst.empty() ? 0U : worst.front().line;
    auto const deviation = worst.empty() ? 0.0 : worst.front().deviation;
    figure.description = say(says::path_described, {{"time", rounded(time(samples_.back()))},
                                                    {"deviation", rounded(deviation)},
                                                    {"line", std::to_string(line)}});
  }

  [[nodiscard]] double largest_deviation() const {
    double largest = 0;
    for (auto const& sample : samples_) largest = std::max(largest, sample.deviation);
    return largest;
  }

  /// The filtered path in classes of its deviation: each class is a curve, interrupted where another one goes
  /// on.
  [[nodiscard]] pictures::Panel plane(std::vector<PathRecorder::Block> const& worst) const {
    pictures::Panel panel;
    panel.height = plane_height;
    panel.y = {.quantity = plot_.axes.second, .unit = "mm"};
    panel.x = pictures::Axis{.quantity = plot_.axes.first, .unit = "mm"};
    pictures::Curve programmed{.name = say(says::path_programmed), .role = pictures::Role::guide};
    for (auto const& sample : samples_) programmed.points.push_back({.x = sample.x, .y = sample.y});
    fit(*panel.x, panel.y, programmed.points);
    panel.curves.push_back(std::move(programmed));
    double const largest = std::max(largest_deviation(), std::numeric_limits<double>::min());
    auto const deviations = deviations_of_filtered();
    for (std::size_t i = 0; i < classes; ++i) {
      double const from = i == 0 ? -1 : largest * static_cast<double>(i) / classes;
      double const to = largest * static_cast<double>(i + 1) / classes;
      auto curve = class_curve(deviations, from, to);
      if (curve.points.empty()) continue;
      curve.name = say(says::path_up_to, {{"deviation", rounded(to)}});
      curve.colour = i;
      panel.curves.push_back(std::move(curve));
    }
    if (plot_.tolerance_um) mark(panel, worst);
    return panel;
  }

  /// What came out lags behind what was programmed: it has the deviation of the nearest point that was
  /// programmed before.
  [[nodiscard]] std::vector<double> deviations_of_filtered() const {
    constexpr std::size_t longest_lag = 400;
    std::vector<double> deviations(samples_.size(), 0.0);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = i > longest_lag ? i - longest_lag : 0; j <= i; ++j) {
        double const distance =
            std::hypot(samples_[j].x - samples_[i].filtered_x, samples_[j].y - samples_[i].filtered_y);
        if (distance > least) continue;
        least = distance;
        deviations[i] = samples_[j].deviation;
      }
    }
    return deviations;
  }

  [[nodiscard]] pictures::Curve class_curve(std::vector<double> const& deviations, double from,
                                            double to) const {
    pictures::Curve curve;
    bool open = false;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      auto const& a = samples_[i - 1];
      auto const& b = samples_[i];
      bool const belongs = deviations[i] > from && deviations[i] <= to;
      if (!belongs) {
        open = false;
        continue;
      }
      if (!open && !curve.points.empty()) {
        curve.points.push_back({.x = a.filtered_x, .y = std::numeric_limits<double>::quiet_NaN()});
      }
      if (!open) curve.points.push_back({.x = a.filtered_x, .y = a.filtered_y});
      curve.points.push_back({.x = b.filtered_x, .y = b.filtered_y});
      open = true;
    }
    return curve;
  }

  static void fit(pictures::Axis& x, pictures::Axis& y, std::vector<pictures::Point> const& points) {
    auto const [left, right] = std::minmax_element(points.begin(), points.end(),
                                                   [](auto const& a, auto const& b) { return a.x < b.x; });
    auto const [lower, upper] = std::minmax_element(points.begin(), points.end(),
                                                    [](auto const& a, auto const& b) { return a.y < b.y; });
    double const air = std::max({right->x - left->x, upper->y - lower->y, 1e-3}) * 0.06;
    x.low = left->x - air;
    x.high = right->x + air;
    y.low = lower->y - air;
    y.high = upper->y + air;
    pictures::make_equal(x, y, plane_height);
  }

  void mark(pictures::Panel& panel, std::vector<PathRecorder::Block> const& worst) const {
    double const line_height = (panel.y.high - panel.y.low) / plane_height * 16;
    std::vector<double> taken;
    for (auto const& block : worst) {
      if (block.deviation <= *plot_.tolerance_um) continue;
      double y = block.y;
      auto const collides = [&] {
        return std::any_of(taken.begin(), taken.end(),
                           [&](double other) { return std::abs(other - y) < line_height; });
      };
      while (collides()) y -= line_height;
      taken.push_back(y);
      double const middle = (panel.x->low + panel.x->high) / 2;
      panel.labels.push_back({.at = {.x = std::min(block.x, middle), .y = y},
                              .words = say(says::path_mark, {{"line", std::to_string(block.line)},
                                                             {"deviation", rounded(block.deviation)}})});
    }
  }

  template <class Quantity>
  [[nodiscard]] pictures::Panel over_time(SentenceRef name, std::string unit, Quantity quantity) const {
    pictures::Panel panel{.y = {.quantity = say(name), .unit = std::move(unit)}};
    pictures::Curve curve{.name = {}, .role = pictures::Role::whole};
    double low = 0;
    double high = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      double const value = quantity(i);
      low = std::min(low, value);
      high = std::max(high, value);
      curve.points.push_back({.x = time(samples_[i]), .y = value});
    }
    double const span = std::max(high - low, 1e-9);
    panel.y.low = low < 0 ? low - span * 0.06 : 0;
    panel.y.high = high + span * 0.06;
    panel.curves.push_back(std::move(curve));
    return panel;
  }

  [[nodiscard]] pictures::Panel deviations() const {
    auto panel = over_time(labels::deviation, "µm", [&](std::size_t i) { return samples_[i].deviation; });
    if (!plot_.tolerance_um) return panel;
    panel.y.high = std::max(panel.y.high, *plot_.tolerance_um * 1.06);
    panel.curves.push_back({.name = say(says::path_tolerance),
                            .role = pictures::Role::guide,
                            .points = {{.x = 0, .y = *plot_.tolerance_um},
                                       {.x = time(samples_.back()), .y = *plot_.tolerance_um}}});
    return panel;
  }

  /// Units per cycle to mm/min.
  [[nodiscard]] pictures::Panel velocities() const {
    double const factor = 60 / plot_.cycle_seconds / motion::units_per_mm;
    return over_time(says::path_velocity_of, "mm/min",
                     [&, factor](std::size_t i) { return samples_[i].velocity * factor; });
  }

  [[nodiscard]] pictures::Panel accelerations() const {
    double const factor = 1 / (plot_.cycle_seconds * plot_.cycle_seconds) / motion::units_per_mm;
    return over_time(says::path_acceleration, "mm/s²", [&, factor](std::size_t i) {
      if (i == 0 || samples_[i].cycle == samples_[i - 1].cycle) return 0.0;
      return (samples_[i].velocity - samples_[i - 1].velocity) / (samples_[i].cycle - samples_[i - 1].cycle) *
             factor;
    });
  }

  PathRecorder const& recorder_;
  PathPlot const& plot_;
  Language language_;
  std::vector<Sample> const& samples_;
};

}  // namespace

pictures::Figure path_figure(PathRecorder const& recorder, PathPlot const& plot, Language language) {
  return PathFigure(recorder, plot, language).make();
}

void PathRecorder::cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) {
  Sample const sample{.cycle = static_cast<double>(point.point.cycle),
                      .x = point.point.nominal[plane_.first] / motion::units_per_mm,
                      .y = point.point.nominal[plane_.second] / motion::units_per_mm,
                      .filtered_x = point.filtered[plane_.first] / motion::units_per_mm,
                      .filtered_y = point.filtered[plane_.second] / motion::units_per_mm,
                      .deviation = point.deviation / motion::units_per_um,
                      .velocity = point.point.velocity,
                      .line = block.line};
  if (current_.line != sample.line) current_ = {.line = sample.line};
  if (sample.deviation >= current_.deviation) {
    current_.deviation = sample.deviation;
    current_.x = sample.x;
    current_.y = sample.y;
  }
  bool const is_kept = seen_++ % stride_ == 0;
  // Between those that are kept only a larger deviation counts.
  if (!is_kept && !samples_.empty()) {
    samples_.back().deviation = std::max(samples_.back().deviation, sample.deviation);
    return;
  }
  samples_.push_back(sample);
  if (samples_.size() == most_samples) thin();
}

void PathRecorder::block(motion::BlockSummary const& summary) {
  auto const known = std::find_if(blocks_.begin(), blocks_.end(),
                                  [&](Block const& block) { return block.line == summary.line; });
  double const deviation = summary.deviation / motion::units_per_um;
  Block const here{.line = summary.line, .deviation = deviation, .x = current_.x, .y = current_.y};
  if (known != blocks_.end()) {
    if (deviation > known->deviation) *known = here;
    return;
  }
  constexpr std::size_t most_blocks = 64;
  blocks_.push_back(here);
  if (blocks_.size() < most_blocks) return;
  blocks_.erase(std::min_element(blocks_.begin(), blocks_.end(),
                                 [](Block const& a, Block const& b) { return a.deviation < b.deviation; }));
}

void PathRecorder::pass(motion::PassSummary const& summary) {
  if (++pass_count_ <= most_passes) passes_.push_back(summary);
}

std::vector<PathRecorder::Block> PathRecorder::worst_blocks(std::size_t count) const {
  auto blocks = blocks_;
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](Block const& a, Block const& b) { return a.deviation > b.deviation; });
  blocks.resize(std::min(blocks.size(), count));
  return blocks;
}

void PathRecorder::thin() {
  std::vector<Sample> kept;
  for (std::size_t i = 0; i + 1 < samples_.size(); i += 2) {
    kept.push_back(samples_[i]);
    kept.back().deviation = std::max(samples_[i].deviation, samples_[i + 1].deviation);
  }
  samples_ = std::move(kept);
  stride_ *= 2;
}

}  // namespace axisc
