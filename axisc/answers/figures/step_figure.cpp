#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace axisc::says {

constexpr Sentence step_title{"Step of the position setpoint: {axes}", "Sprung des Lagesollwerts: {axes}"};
constexpr Sentence step_described{"{axis}: overshoot {overshoot} %, {settling}",
                                  "{axis}: Überschwingen {overshoot} %, {settling}"};
constexpr Sentence step_settled{"within 0.01 % after {time} ms", "nach {time} ms auf 0,01 % eingeschwungen"};
constexpr Sentence step_unsettled{"not within 0.01 % after {time} ms",
                                  "nach {time} ms nicht auf 0,01 % eingeschwungen"};
constexpr Sentence position{"position", "Lage"};
constexpr Sentence velocity{"velocity", "Geschwindigkeit"};
constexpr Sentence acceleration{"acceleration", "Beschleunigung"};
constexpr Sentence step_before{"{axis}, before", "{axis}, vorher"};
constexpr Sentence settled_mark{"{axis} settled", "{axis} eingeschwungen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// A chain that takes longer is shown as long as this.
constexpr std::uint64_t longest_shown = 20'000;
constexpr std::uint64_t shortest_shown = 10;

/// One axis of one image.
struct Chain {
  PlottedImage image;
  std::size_t axis = 0;
  std::string name;
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  image::ChainFigures figures;

  [[nodiscard]] double milliseconds() const { return image.contents().cycle_time.seconds() * 1e3; }
  /// Until the answer has settled and a bit more.
  [[nodiscard]] double shown_time() const {
    auto const cycles = std::max(shortest_shown, figures.settling_cycles.value_or(longest_shown));
    return static_cast<double>(std::min(cycles + cycles / 5, longest_shown)) * milliseconds();
  }
};

/// Of a chain, from the cycle before the step on.
using Signal = std::vector<double>;

Signal difference(Signal const& signal, double seconds) {
  Signal result(1, 0.0);
  for (std::size_t n = 1; n < signal.size(); ++n) result.push_back((signal[n] - signal[n - 1]) / seconds);
  return result;
}

class StepFigure {
 public:
  explicit StepFigure(PlotSubject const& subject) : subject_(subject) {
    for (std::size_t i = 0; i < subject.axes.size(); ++i) {
      auto const axis = subject.axes[i];
      std::string const name = subject.name(axis);
      if (auto const old = subject.axis_before(axis)) {
        add(*subject.before, *old, subject.say(says::step_before, {{"axis", name}}), pictures::Role::before,
            i);
      }
      add(subject.now, axis, name, pictures::Role::whole, i);
    }
    find_figures(subject.now);
    if (subject.before) find_figures(*subject.before);
  }

  pictures::Figure make() {
    pictures::Figure figure;
    figure.title = subject_.say(says::step_title, {{"axes", subject_.names()}});
    figure.description = description();
    figure.table = chain_table(subject_, {});
    double longest = 0;
    for (auto const& chain : chains_) longest = std::max(longest, chain.shown_time());
    figure.x = {.quantity = subject_.say(labels::time), .unit = "ms", .low = 0, .high = longest};
    std::vector<Signal> const positions = answers(longest);
    std::vector<Signal> velocities;
    std::vector<Signal> accelerations;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      double const seconds = chains_[i].milliseconds() / 1e3;
      velocities.push_back(difference(positions[i], seconds));
      accelerations.push_back(difference(velocities.back(), seconds));
    }
    figure.panels.push_back(panel({says::position, ""}, positions));
    figure.panels.push_back(panel({says::velocity, "1/s"}, velocities));
    figure.panels.push_back(panel({says::acceleration, "1/s²"}, accelerations));
    std::map<double, std::string> settled;
    for (auto const& chain : chains_) {
      if (!chain.figures.settling_cycles) continue;
      double const time = static_cast<double>(*chain.figures.settling_cycles) * chain.milliseconds();
      if (time > longest) continue;
      std::string& names = settled[time];
      names += (names.empty() ? "" : ", ") + chain.name;
    }
    for (auto const& [time, names] : settled) {
      figure.marks.push_back({.at = time, .label = subject_.say(says::settled_mark, {{"axis", names}})});
    }
    return figure;
  }

 private:
  struct Quantity {
    SentenceRef name;
    std::string unit;
  };

  void add(PlottedImage const& image, std::size_t axis, std::string name, pictures::Role role,
           std::size_t colour) {
    chains_.push_back({.image = image,
                       .axis = axis,
                       .name = std::move(name),
                       .role = role,
                       .colour = colour,
                       .figures = {}});
  }

  [[nodiscard]] std::vector<std::size_t> chains_of(PlottedImage const& image) const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (&chains_[i].image.host == &image.host) indices.push_back(i);
    }
    return indices;
  }

  void find_figures(PlottedImage const& image) {
    auto const indices = chains_of(image);
    std::vector<std::size_t> axes;
    axes.reserve(indices.size());
    for (auto const i : indices) axes.push_back(chains_[i].axis);
    auto const figures = figures_of(image, axes);
    for (std::size_t i = 0; i < indices.size(); ++i) chains_[indices[i]].figures = figures[i];
  }

  [[nodiscard]] std::string description() const {
    std::string text;
    for (auto const& chain : chains_) {
      auto const cycles = chain.figures.settling_cycles.value_or(image::longest_settling);
      Wording const time =
          format_rounded(static_cast<double>(cycles) * chain.milliseconds(), pictures::shown_digits);
      auto const settling =
          chain.figures.settling_cycles ? SentenceRef(says::step_settled) : SentenceRef(says::step_unsettled);
      text +=
          (text.empty() ? "" : "; ") +
          subject_.say(says::step_described,
                       {{"axis", chain.name},
                        {"overshoot", format_rounded(chain.figures.overshoot * 100, pictures::shown_digits)},
                        {"settling", subject_.say(settling, {{"time", time}})}});
    }
    return text;
  }

  /// Of all chains: each image is executed once.
  [[nodiscard]] std::vector<Signal> answers(double milliseconds) const {
    std::vector<Signal> signals(chains_.size(), Signal(1, 0.0));
    execute(subject_.now, milliseconds, signals);
    if (subject_.before) execute(*subject_.before, milliseconds, signals);
    return signals;
  }

  void execute(PlottedImage const& image, double milliseconds, std::vector<Signal>& signals) const {
    auto const indices = chains_of(image);
    if (indices.empty()) return;
    double const cycle = image.contents().cycle_time.seconds() * 1e3;
    auto const cycles = static_cast<std::uint64_t>(std::ceil(milliseconds / cycle));
    if (image.steps != nullptr) {
      for (auto const i : indices) {
        auto const answer = image.steps->answer(chains_[i].axis, cycles);
        signals[i].insert(signals[i].end(), answer.begin(), answer.end());
      }
      return;
    }
    static_cast<void>(image.host.reset_all(0));
    std::vector<double> const setpoints(image.contents().axes.size(), 1);
    std::vector<double> filtered(setpoints.size());
    for (std::uint64_t n = 0; n < cycles; ++n) {
      static_cast<void>(image.host.step(setpoints, filtered));
      for (auto const i : indices) signals[i].push_back(filtered[chains_[i].axis]);
    }
  }

  [[nodiscard]] pictures::Panel panel(Quantity const& quantity, std::vector<Signal> const& signals) const {
    pictures::Panel panel;
    double low = 0;
    double high = 0;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      auto const& chain = chains_[i];
      pictures::Curve curve{.name = chain.name, .role = chain.role, .colour = chain.colour, .points = {}};
      for (std::size_t n = 0; n < signals[i].size(); ++n) {
        curve.points.push_back({.x = static_cast<double>(n) * chain.milliseconds(), .y = signals[i][n]});
        low = std::min(low, signals[i][n]);
        high = std::max(high, signals[i][n]);
      }
      panel.curves.push_back(std::move(curve));
    }
    double const span = std::max(high - low, 1e-9);
    panel.y = {.quantity = subject_.say(quantity.name),
               .unit = quantity.unit,
               .low = low - span * 0.06,
               .high = high + span * 0.06};
    return panel;
  }

  PlotSubject const& subject_;
  std::vector<Chain> chains_;
};

}  // namespace

pictures::Figure step_figure(PlotSubject const& subject) {
  subject.require_drawable();
  return StepFigure(subject).make();
}

}  // namespace axisc
