#include "cli/plots/plots.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace axisc::cli::says {

constexpr Sentence step_title{"Step of the position setpoint: {axes}", "Sprung des Lagesollwerts: {axes}"};
constexpr Sentence step_described{"{axis}: overshoot {overshoot} %, {settling}",
                                  "{axis}: Überschwingen {overshoot} %, {settling}"};
constexpr Sentence step_settled{"within 0.01 % after {time} ms", "nach {time} ms auf 0,01 % eingeschwungen"};
constexpr Sentence step_unsettled{"not within 0.01 % after {time} ms",
                                  "nach {time} ms nicht auf 0,01 % eingeschwungen"};
constexpr Sentence time{"time", "Zeit"};
constexpr Sentence position{"position", "Lage"};
constexpr Sentence velocity{"velocity", "Geschwindigkeit"};
constexpr Sentence acceleration{"acceleration", "Beschleunigung"};
constexpr Sentence settled_mark{"{axis} settled", "{axis} eingeschwungen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr int shown_digits = 4;
/// A chain that takes longer is shown as long as this.
constexpr std::uint64_t longest_shown = 20'000;
constexpr std::uint64_t shortest_shown = 10;

class StepFigure {
 public:
  explicit StepFigure(PlotSubject const& subject) : subject_(subject), contents_(subject.file.contents) {
    for (auto const axis : subject.axes) {
      chains_.push_back(image::chain_figures(subject.file.bytes.bytes(), contents_, axis));
    }
  }

  pictures::Figure make() {
    pictures::Figure figure;
    figure.title = say(says::step_title, {{"axes", names()}});
    figure.description = description();
    std::uint64_t const cycles = shown_cycles();
    figure.x = {.quantity = say(says::time),
                .unit = "ms",
                .low = 0,
                .high = static_cast<double>(cycles) * milliseconds()};
    auto const positions = outputs(cycles);
    double const seconds = contents_.cycle_time.seconds();
    figure.panels.push_back(panel({says::position, ""}, positions));
    auto const velocities = differences(positions, seconds);
    figure.panels.push_back(panel({says::velocity, "1/s"}, velocities));
    figure.panels.push_back(panel({says::acceleration, "1/s²"}, differences(velocities, seconds)));
    std::map<std::uint64_t, std::string> settled;
    for (std::size_t i = 0; i < subject_.axes.size(); ++i) {
      if (!chains_[i].settling_cycles || *chains_[i].settling_cycles > cycles) continue;
      std::string& axes = settled[*chains_[i].settling_cycles];
      axes += (axes.empty() ? "" : ", ") + name(i);
    }
    for (auto const& [cycle, axes] : settled) {
      figure.marks.push_back({.at = static_cast<double>(cycle) * milliseconds(),
                              .label = say(says::settled_mark, {{"axis", axes}})});
    }
    return figure;
  }

 private:
  struct Quantity {
    SentenceRef name;
    std::string unit;
  };
  /// Of each axis, from the cycle before the step on.
  using Signals = std::vector<std::vector<double>>;

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({.sentence = text, .arguments = std::move(arguments)}, subject_.language);
  }

  [[nodiscard]] std::string name(std::size_t i) const { return axis_label(contents_, subject_.axes[i]); }

  [[nodiscard]] double milliseconds() const { return contents_.cycle_time.seconds() * 1e3; }

  [[nodiscard]] std::string names() const {
    std::string text;
    for (std::size_t i = 0; i < subject_.axes.size(); ++i) text += (i == 0 ? "" : ", ") + name(i);
    return text;
  }

  [[nodiscard]] std::string description() const {
    std::string text;
    for (std::size_t i = 0; i < subject_.axes.size(); ++i) {
      auto const cycles = chains_[i].settling_cycles.value_or(image::longest_settling);
      std::string const time = format_rounded(static_cast<double>(cycles) * milliseconds(), shown_digits);
      text += (i == 0 ? "" : "; ") +
              say(says::step_described,
                  {{"axis", name(i)},
                   {"overshoot", format_rounded(chains_[i].overshoot * 100, shown_digits)},
                   {"settling", say(chains_[i].settling_cycles ? says::step_settled : says::step_unsettled,
                                    {{"time", time}})}});
    }
    return text;
  }

  [[nodiscard]] std::uint64_t shown_cycles() const {
    std::uint64_t longest = shortest_shown;
    for (auto const& chain : chains_) {
      longest = std::max(longest, chain.settling_cycles.value_or(longest_shown));
    }
    return std::min(longest + longest / 5, longest_shown);
  }

  [[nodiscard]] Signals outputs(std::uint64_t cycles) const {
    image::RuntimeHost& host = subject_.host;
    static_cast<void>(host.reset_all(0));
    std::vector<double> const setpoints(contents_.axes.size(), 1);
    std::vector<double> filtered(contents_.axes.size());
    Signals signals(subject_.axes.size(), std::vector<double>{0});
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) {
      static_cast<void>(host.step(setpoints, filtered));
      for (std::size_t i = 0; i < signals.size(); ++i) signals[i].push_back(filtered[subject_.axes[i]]);
    }
    return signals;
  }

  [[nodiscard]] static Signals differences(Signals const& signals, double cycle_time) {
    Signals result;
    for (auto const& signal : signals) {
      auto& differences = result.emplace_back(1, 0.0);
      for (std::size_t n = 1; n < signal.size(); ++n) {
        differences.push_back((signal[n] - signal[n - 1]) / cycle_time);
      }
    }
    return result;
  }

  [[nodiscard]] pictures::Panel panel(Quantity const& quantity, Signals const& signals) const {
    pictures::Panel panel;
    double low = 0;
    double high = 0;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      pictures::Curve curve{.name = name(i), .role = pictures::Role::whole, .colour = i, .points = {}};
      for (std::size_t n = 0; n < signals[i].size(); ++n) {
        curve.points.push_back({.x = static_cast<double>(n) * milliseconds(), .y = signals[i][n]});
        low = std::min(low, signals[i][n]);
        high = std::max(high, signals[i][n]);
      }
      panel.curves.push_back(std::move(curve));
    }
    double const span = std::max(high - low, 1e-9);
    panel.y = {.quantity = say(quantity.name),
               .unit = quantity.unit,
               .low = low - span * 0.06,
               .high = high + span * 0.06};
    return panel;
  }

  PlotSubject const& subject_;
  image::ImageContents const& contents_;
  std::vector<image::ChainFigures> chains_;
};

}  // namespace

pictures::Figure step_figure(PlotSubject const& subject) {
  return StepFigure(subject).make();
}

}  // namespace axisc::cli
