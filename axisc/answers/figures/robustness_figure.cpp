#include "axisc/answers/figures/robustness_figure.hpp"

#include "axisc/answers/figures/guard_states.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::says {

constexpr Sentence robustness_title{"Robustness of Vibration Guard (a reading): {axes}",
                                    "Robustheit des Vibration Guard (eine Lesart): {axes}"};
constexpr Sentence robustness_guard{"{axes}: mode {mode}, {frequency} Hz, damping {damping}",
                                    "{axes}: Modus {mode}, {frequency} Hz, Dämpfung {damping}"};
constexpr Sentence robustness_command{"{axes}, {command}", "{axes}, {command}"};
constexpr Sentence robustness_before{"{guard}, before", "{guard}, vorher"};
constexpr Sentence robustness_said{"{guard}: at most 5 % left from {from} to {to} Hz",
                                   "{guard}: höchstens 5 % übrig von {from} bis {to} Hz"};
constexpr Sentence robustness_nowhere{"{guard}: {residual} % left at its own frequency",
                                      "{guard}: bei der eigenen Frequenz {residual} % übrig"};
constexpr Sentence robustness_none{"No axis has a Vibration Guard.",
                                   "Keine Achse hat einen Vibration Guard."};
constexpr Sentence robustness_left{"vibration left", "verbleibende Schwingung"};
constexpr Sentence robustness_oscillation{"frequency of the oscillation", "Frequenz der Schwingung"};
constexpr Sentence robustness_ratio{"frequency of the oscillation / frequency of the guard",
                                    "Frequenz der Schwingung / Frequenz des Guards"};
constexpr Sentence robustness_limit{"5 %", "5 %"};
constexpr Sentence robustness_mode{"mode {mode}", "Modus {mode}"};
constexpr Sentence robustness_guide{"guide values of the manual, at a damping of 0.1",
                                    "Richtwerte des Handbuchs, bei einer Dämpfung von 0,1"};
constexpr Sentence robustness_guard_column{"guard", "Guard"};
constexpr Sentence robustness_quantity{"quantity", "Größe"};
constexpr Sentence robustness_now{"now", "jetzt"};
constexpr Sentence robustness_delay{"delay [ms]", "Verzögerung [ms]"};
constexpr Sentence robustness_own{"left at its own frequency [%]", "übrig bei der eigenen Frequenz [%]"};
constexpr Sentence robustness_from{"at most 5 % from [Hz]", "höchstens 5 % von [Hz]"};
constexpr Sentence robustness_to{"at most 5 % to [Hz]", "höchstens 5 % bis [Hz]"};
constexpr Sentence robustness_lowest{"configured/actual, lowest [%]", "eingestellt/tatsächlich, von [%]"};
constexpr Sentence robustness_highest{"configured/actual, highest [%]", "eingestellt/tatsächlich, bis [%]"};
constexpr Sentence guide_lowest{"documented for a damping of 0.1, lowest [%]",
                                "dokumentiert für eine Dämpfung von 0,1, von [%]"};
constexpr Sentence guide_highest{"documented for a damping of 0.1, highest [%]",
                                 "dokumentiert für eine Dämpfung von 0,1, bis [%]"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double percent = 100;
constexpr double lowest_ratio = 0.5;  ///< of the oscillation to the guard, drawn
constexpr double highest_ratio = 1.5;

/// A guard with its curve.
struct DrawnGuard {
  std::string name;
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  ShownGuard const* guard = nullptr;
};

constexpr std::array<SentenceRef, 8> quantities = {
    says::robustness_delay,  says::robustness_own,     says::robustness_from, says::robustness_to,
    says::robustness_lowest, says::robustness_highest, says::guide_lowest,    says::guide_highest};

/// In the order of the quantities.
using Values = std::array<std::optional<double>, quantities.size()>;

Values values_of(ShownGuard const& shown) {
  auto const of_interval = [&](auto const& value) {
    return shown.interval ? std::optional<double>(value(*shown.interval)) : std::nullopt;
  };
  using Interval = design::Robustness;
  auto const [lowest, highest] = design::guide_values(shown.specification.order);
  return {shown.design.group_delay_cycles * shown.cycle_time.seconds() * 1e3,
          percent * shown.residual,
          of_interval([](Interval const& interval) { return interval.from.value; }),
          of_interval([](Interval const& interval) { return interval.to.value; }),
          of_interval([](Interval const& interval) { return percent * interval.lowest; }),
          of_interval([](Interval const& interval) { return percent * interval.highest; }),
          percent * lowest,
          percent * highest};
}

class RobustnessFigure {
 public:
  explicit RobustnessFigure(PlotSubject const& subject) : subject_(subject), states_(guard_states(subject)) {
    for (auto const& state : states_) {
      if (state.before) add(state, *state.before, true);
      if (state.now) add(state, *state.now, false);
    }
  }

  pictures::Figure make() const {
    pictures::Figure figure;
    figure.title = subject_.say(says::robustness_title, {{"axes", subject_.names()}});
    if (drawn_.empty()) {
      figure.nothing = subject_.say(says::robustness_none);
      figure.description = figure.nothing;
      return figure;
    }
    for (auto const& one : drawn_) figure.description += (figure.description.empty() ? "" : "; ") + said(one);
    figure.table = table();
    figure.x = frequencies();
    add_marks(figure);
    figure.panels = {left_panel(figure.x), interval_panel()};
    return figure;
  }

 private:
  void add(GuardStates const& state, ShownGuard const& guard, bool was) {
    auto name = guard_name(state, guard);
    if (was) name = subject_.say(says::robustness_before, {{"guard", name}});
    drawn_.push_back({.name = std::move(name),
                      .role = was ? pictures::Role::before : pictures::Role::whole,
                      .colour = drawn_.size(),
                      .guard = &guard});
  }

  [[nodiscard]] std::string of_axes(GuardStates const& state) const {
    if (state.command.empty()) return state.axes;
    return subject_.say(says::robustness_command, {{"axes", state.axes}, {"command", state.command}});
  }

  [[nodiscard]] std::string guard_name(GuardStates const& state, ShownGuard const& shown) const {
    auto const& guard = shown.specification;
    return subject_.say(says::robustness_guard, {{"axes", of_axes(state)},
                                                 {"mode", std::to_string(guard.order)},
                                                 {"frequency", exact_number(guard.frequency.value)},
                                                 {"damping", exact_number(guard.quality)}});
  }

  [[nodiscard]] std::string said(DrawnGuard const& one) const {
    auto const number = [](double value) { return format_rounded(value, pictures::shown_digits); };
    auto const& interval = one.guard->interval;
    if (!interval) {
      return subject_.say(says::robustness_nowhere,
                          {{"guard", one.name}, {"residual", number(percent * one.guard->residual)}});
    }
    return subject_.say(
        says::robustness_said,
        {{"guard", one.name}, {"from", number(interval->from.value)}, {"to", number(interval->to.value)}});
  }

  /// From half the lowest frequency to one and a half times the highest.
  [[nodiscard]] pictures::Axis frequencies() const {
    auto const [low, high] =
        std::minmax_element(drawn_.begin(), drawn_.end(), [](DrawnGuard const& a, DrawnGuard const& b) {
          return a.guard->specification.frequency < b.guard->specification.frequency;
        });
    return {.quantity = subject_.say(says::robustness_oscillation),
            .unit = "Hz",
            .low = lowest_ratio * low->guard->specification.frequency.value,
            .high = highest_of(*high)};
  }

  [[nodiscard]] static double highest_of(DrawnGuard const& one) {
    return std::min(highest_ratio * one.guard->specification.frequency.value,
                    one.guard->cycle_time.nyquist().value);
  }

  void add_marks(pictures::Figure& figure) const {
    auto const add = [&](double frequency) {
      auto const label = format_rounded(frequency, pictures::shown_digits).in(subject_.language) + " Hz";
      auto const is_known = std::any_of(figure.marks.begin(), figure.marks.end(),
                                        [&](pictures::Mark const& mark) { return mark.label == label; });
      if (!is_known) figure.marks.push_back({.at = frequency, .label = label});
    };
    for (auto const& one : drawn_) add(one.guard->specification.frequency.value);
    constexpr std::size_t told_apart = 3;
    if (drawn_.size() > told_apart) return;
    for (auto const& one : drawn_) {
      if (!one.guard->interval) continue;
      add(one.guard->interval->from.value);
      add(one.guard->interval->to.value);
    }
  }

  [[nodiscard]] pictures::Panel left_panel(pictures::Axis const& x) const {
    constexpr double height = 240;
    constexpr double step = 10;
    double highest = 0;
    pictures::Panel panel;
    panel.y = {.quantity = subject_.say(says::robustness_left), .unit = "%", .low = 0, .high = percent};
    panel.height = height;
    double const limit = percent * design::permitted_residual;
    panel.curves.push_back({.name = subject_.say(says::robustness_limit),
                            .role = pictures::Role::guide,
                            .points = {{.x = x.low, .y = limit}, {.x = x.high, .y = limit}}});
    for (auto const& one : drawn_) {
      auto const& guard = one.guard->specification;
      pictures::Axis own = x;
      own.low = lowest_ratio * guard.frequency.value;
      own.high = highest_of(one);
      std::array const exact = {guard.frequency.value};
      auto points = pictures::sample(own, panel.y, exact, [&](double frequency) {
        return percent * design::residual_vibration(one.guard->design, {frequency}, guard.quality,
                                                    one.guard->cycle_time);
      });
      for (auto const& point : points) highest = std::max(highest, point.y);
      panel.curves.push_back(curve_of(one, one.role, std::move(points)));
    }
    panel.y.high = step * std::ceil((highest + 1) / step);
    return panel;
  }

  /// A row for each guard: where it leaves at most 5 %, and where the vendor says so.
  [[nodiscard]] pictures::Panel interval_panel() const {
    constexpr double row_height = 34;
    constexpr double below = 0.36;  // of a row: the bar of the guard is above
    auto const rows = static_cast<double>(drawn_.size());
    pictures::Panel panel{
        .y = {.quantity = subject_.say(says::robustness_guard_column), .low = -0.7, .high = rows - 0.5},
        .height = row_height * std::max(rows, 2.0),
        .x = pictures::Axis{
            .quantity = subject_.say(says::robustness_ratio), .low = lowest_ratio, .high = highest_ratio}};
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      auto const& one = drawn_[i];
      auto const& guard = one.guard->specification;
      double const y = rows - 1 - static_cast<double>(i);
      panel.y.ticks.push_back(y);
      panel.y.names.push_back(subject_.say(says::robustness_mode, {{"mode", std::to_string(guard.order)}}));
      if (auto const& interval = one.guard->interval) {
        double const f = guard.frequency.value;
        panel.curves.push_back(
            curve_of(one, pictures::Role::bar,
                     {{.x = interval->from.value / f, .y = y}, {.x = interval->to.value / f, .y = y}}));
      }
      auto const [lowest, highest] = design::guide_values(guard.order);
      panel.curves.push_back(
          {.name = subject_.say(says::robustness_guide),
           .role = pictures::Role::guide,
           .points = {{.x = 1 / (1 + highest), .y = y - below}, {.x = 1 / (1 + lowest), .y = y - below}}});
    }
    return panel;
  }

  static pictures::Curve curve_of(DrawnGuard const& one, pictures::Role role,
                                  std::vector<pictures::Point> points) {
    return {.name = one.name, .role = role, .colour = one.colour, .points = std::move(points)};
  }

  [[nodiscard]] pictures::Table table() const {
    pictures::Table table;
    table.header = {subject_.say(says::robustness_guard_column), subject_.say(says::robustness_quantity)};
    if (subject_.before) {
      table.header.push_back(subject_.say(labels::before));
      table.header.push_back(subject_.say(says::robustness_now));
      table.header.push_back(subject_.say(labels::difference));
    } else {
      table.header.push_back(subject_.say(labels::value));
    }
    auto const cell = [&](std::optional<double> const& value) {
      return value ? format_rounded(*value, pictures::shown_digits).in(subject_.language) : "-";
    };
    for (auto const& state : states_) {
      auto const now = state.now ? values_of(*state.now) : Values();
      auto const old = state.before ? values_of(*state.before) : Values();
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        std::vector<std::string> row{of_axes(state), subject_.say(quantities[i])};
        if (subject_.before) row.push_back(cell(old[i]));
        row.push_back(cell(now[i]));
        bool const has_both = now[i] && old[i];
        if (subject_.before) row.push_back(cell(has_both ? std::optional(*now[i] - *old[i]) : std::nullopt));
        table.rows.push_back(std::move(row));
      }
    }
    return table;
  }

  PlotSubject const& subject_;
  std::vector<GuardStates> states_;
  std::vector<DrawnGuard> drawn_;
};

}  // namespace

bool has_guard(image::ImageContents const& contents, std::size_t axis) {
  auto const& slot = contents.axes[axis].slot;
  return slot && slot->family == machine::KernelFamily::guard;
}

pictures::Figure robustness_figure(PlotSubject const& subject) {
  subject.require_drawable();
  return RobustnessFigure(subject).make();
}

}  // namespace axisc
