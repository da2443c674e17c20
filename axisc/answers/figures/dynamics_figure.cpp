#include "axisc/answers/dynamics/driven_axis.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/figures/dynamics_table.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence dynamics_title{
    "{axes}: {distance} at F{feed} from rest to rest, slope {slope}",
    "{axes}: {distance} mit F{feed} von Stillstand zu Stillstand, Slope {slope}"};
constexpr Sentence dynamics_without{"{title}; not computed: {parameters}",
                                    "{title}; nicht berechnet: {parameters}"};
constexpr Sentence dynamics_said{"{motion}: {time} s, {velocity} {unit}",
                                 "{motion}: {time} s, {velocity} {unit}"};
constexpr Sentence dynamics_feed{"{axis}, F{feed}", "{axis}, F{feed}"};
constexpr Sentence dynamics_rapid{"{axis}, G00", "{axis}, G00"};
constexpr Sentence dynamics_legend{"{motion}: {time} s", "{motion}: {time} s"};
constexpr Sentence dynamics_before{"{axis}, before", "{axis}, vorher"};
constexpr Sentence default_slope{"{slope} (default: no channel list)",
                                 "{slope} (Standardwert: keine Kanalliste)"};
constexpr Sentence slope_of_reading{"{slope} (reading)", "{slope} (Lesart)"};
constexpr Sentence dynamics_none{"No channel moves {axes} along a path.",
                                 "Kein Kanal bewegt {axes} auf einer Bahn."};
constexpr Sentence dynamics_velocity{"velocity", "Geschwindigkeit"};
constexpr Sentence dynamics_acceleration{"acceleration", "Beschleunigung"};
constexpr Sentence reached_mark{"{velocity} {unit} after {time} s", "{velocity} {unit} nach {time} s"};
constexpr Sentence braking_mark{"brakes from {time} s on", "bremst ab {time} s"};
constexpr Sentence rest_mark{"at rest after {time} s", "steht nach {time} s"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// A motion that is drawn.
struct DrawnMove {
  std::string name;
  std::string unit;  ///< of ways: "mm", "°"
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  DrivenAxis driven;
  PlannedMove move;
};

/// Points of a phase: a parabola, or a sine's integral, is at most a tenth of a pixel from the line between
/// two of them.
constexpr int points_per_phase = 32;

class DynamicsFigure {
 public:
  DynamicsFigure(PlotSubject const& subject, WantedMove const& wanted) : subject_(subject), wanted_(wanted) {
    for (auto const axis : subject.axes) add_axis(axis);
  }

  pictures::Figure make() {
    pictures::Figure figure;
    if (moves_.empty()) {
      figure.title = subject_.say(says::dynamics_velocity);
      figure.nothing = subject_.say(says::dynamics_none, {{"axes", subject_.names()}});
      return figure;
    }
    figure.title = title();
    figure.description = description();
    figure.table = dynamics_table(rows_, {.feed = exact_number(wanted_.feed_mm_per_min),
                                          .has_before = subject_.before.has_value(),
                                          .language = subject_.language});
    constexpr double air = 1.04;
    figure.x = {.quantity = subject_.say(labels::time), .unit = "s", .low = 0, .high = longest() * air};
    figure.panels.push_back(velocities());
    figure.panels.push_back(accelerations());
    if (names_.size() == 1 && !subject_.before) add_marks(figure);
    return figure;
  }

 private:
  [[nodiscard]] std::string rounded(double value) const {
    return format_rounded(value, pictures::shown_digits).in(subject_.language);
  }

  void add_axis(std::size_t axis) {
    auto const driven = driven_axis(*subject_.now.machine, axis);
    if (!driven) return;
    auto const name = subject_.name(axis);
    auto const colour = names_.size();
    names_.push_back(name);
    bool const is_linear = subject_.now.machine->axes[axis].type == machine::AxisType::translatory;
    std::string const unit = is_linear ? "mm" : "°";
    note(units_, unit);
    std::optional<DrivenState> before;
    if (auto const old = subject_.axis_before(axis)) {
      if (auto const was = driven_axis(*subject_.before->machine, *old)) {
        before = state_of(*was);
        add(*before, unit, subject_.say(says::dynamics_before, {{"axis", name}}), pictures::Role::before,
            colour);
      }
    }
    note_slope(*driven);
    auto const now = state_of(*driven);
    add(now, unit, name, pictures::Role::whole, colour);
    rows_.push_back({.axis = name, .unit = unit, .before = before, .now = now});
  }

  [[nodiscard]] DrivenState state_of(DrivenAxis const& driven) const {
    return {.driven = driven, .at_feed = driven.feed(wanted_), .in_rapid = driven.rapid(wanted_.distance_mm)};
  }

  /// G00 is drawn beside a single axis alone.
  void add(DrivenState const& state, std::string const& unit, std::string const& name, pictures::Role role,
           std::size_t colour) {
    auto const& driven = state.driven;
    Wording const feed = exact_number(wanted_.feed_mm_per_min);
    bool const is_single = subject_.axes.size() == 1 && !subject_.before;
    for (auto const& parameter : driven.uncomputed()) note(uncomputed_, parameter);
    moves_.push_back(
        {.name = is_single ? subject_.say(says::dynamics_feed, {{"axis", name}, {"feed", feed}}) : name,
         .unit = unit,
         .role = role,
         .colour = colour,
         .driven = driven,
         .move = state.at_feed});
    if (!is_single) return;
    moves_.push_back({.name = subject_.say(says::dynamics_rapid, {{"axis", name}}),
                      .unit = unit,
                      .role = pictures::Role::part,
                      .colour = colour + 1,
                      .driven = driven,
                      .move = state.in_rapid});
  }

  void note_slope(DrivenAxis const& driven) {
    std::string word(slope_name(driven.slope()));
    bool const is_reading = driven.slope() == machine::Slope::sin2 || driven.slope() == machine::Slope::hsc;
    if (!driven.has_channel_list()) word = subject_.say(says::default_slope, {{"slope", word}});
    if (is_reading) word = subject_.say(says::slope_of_reading, {{"slope", word}});
    note(slopes_, word);
  }

  static void note(std::vector<std::string>& words, std::string const& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }

  /// "100 mm", "100°", with linear and rotary axes "100 mm, 100°".
  [[nodiscard]] std::string distance() const {
    std::string const number = exact_number(wanted_.distance_mm).in(subject_.language);
    std::vector<std::string> distances;
    for (auto const& unit : units_) {
      distances.emplace_back(number).append(unit == "°" ? "" : " ").append(unit);
    }
    return joined(distances);
  }

  /// "mm/s", "mm/s, °/s".
  [[nodiscard]] std::string units_per(std::string_view time) const {
    return joined(units_, std::string(time) + ", ").append(time);
  }

  [[nodiscard]] std::string title() const {
    auto title = subject_.say(says::dynamics_title, {{"axes", joined(names_)},
                                                     {"distance", distance()},
                                                     {"feed", exact_number(wanted_.feed_mm_per_min)},
                                                     {"slope", joined(slopes_)}});
    if (uncomputed_.empty()) return title;
    return subject_.say(says::dynamics_without, {{"title", title}, {"parameters", joined(uncomputed_)}});
  }

  [[nodiscard]] std::string description() const {
    std::string text;
    for (auto const& drawn : moves_) {
      text += (text.empty() ? "" : "; ") +
              subject_.say(says::dynamics_said, {{"motion", drawn.name},
                                                 {"time", rounded(drawn.move.seconds)},
                                                 {"velocity", rounded(drawn.move.velocity)},
                                                 {"unit", drawn.unit + "/s"}});
    }
    return text;
  }

  [[nodiscard]] double longest() const {
    double time = 0;
    for (auto const& drawn : moves_) time = std::max(time, drawn.move.seconds);
    return time;
  }

  /// `value` of a phase at a time, in the panel's unit. At rest before and after, it is 0.
  template <class ValueOf>
  [[nodiscard]] pictures::Panel panel(SentenceRef quantity, std::string unit, ValueOf value) const {
    pictures::Panel panel;
    double low = 0;
    double high = 0;
    for (auto const& drawn : moves_) {
      pictures::Curve curve{
          .name = subject_.say(says::dynamics_legend,
                               {{"motion", drawn.name}, {"time", rounded(drawn.move.seconds)}}),
          .role = drawn.role,
          .colour = drawn.colour,
          .points = {{.x = 0, .y = 0}}};
      double begin = 0;
      for (auto const& phase : drawn.move.phases) {
        for (int i = 0; i <= points_per_phase; ++i) {
          double const t = phase.duration * i / points_per_phase;
          double const y = value(drawn.driven, phase, t);
          curve.points.push_back({.x = drawn.driven.seconds(begin + t), .y = y});
          low = std::min(low, y);
          high = std::max(high, y);
        }
        begin += phase.duration;
      }
      curve.points.push_back({.x = drawn.driven.seconds(begin), .y = 0});
      panel.curves.push_back(std::move(curve));
    }
    constexpr double air = 0.06;
    double const span = high - low;
    panel.y = {.quantity = subject_.say(quantity),
               .unit = std::move(unit),
               .low = low < 0 ? low - span * air : 0,
               .high = high + span * air};
    return panel;
  }

  [[nodiscard]] pictures::Panel velocities() const {
    return panel(says::dynamics_velocity, units_per("/s"),
                 [](DrivenAxis const& driven, motion::Phase const& phase, double t) {
                   return driven.velocity(phase.velocity_at(t));
                 });
  }

  [[nodiscard]] pictures::Panel accelerations() const {
    return panel(says::dynamics_acceleration, units_per("/s²"),
                 [](DrivenAxis const& driven, motion::Phase const& phase, double t) {
                   return driven.acceleration(phase.acceleration_at(t));
                 });
  }

  /// Where the bold motion is at its velocity, brakes, and stands.
  void add_marks(pictures::Figure& figure) const {
    auto const& drawn = moves_.front();
    constexpr double rounding = 1e-9;
    double time = 0;
    double fast = 0;
    double brakes = 0;
    for (auto const& phase : drawn.move.phases) {
      time += phase.duration;
      if (phase.velocity_out() > phase.velocity * (1 + rounding)) fast = time;
      if (phase.is_steady()) brakes = time;
    }
    auto const mark = [&](double cycles, SentenceRef sentence) {
      double const seconds = drawn.driven.seconds(cycles);
      figure.marks.push_back({.at = seconds,
                              .label = subject_.say(sentence, {{"time", rounded(seconds)},
                                                               {"velocity", rounded(drawn.move.velocity)},
                                                               {"unit", drawn.unit + "/s"}})});
    };
    mark(fast, says::reached_mark);
    if (brakes > fast * (1 + rounding)) mark(brakes, says::braking_mark);
    mark(time, says::rest_mark);
  }

  PlotSubject const& subject_;
  WantedMove const& wanted_;
  std::vector<DrawnMove> moves_;
  std::vector<DynamicsRows> rows_;
  std::vector<std::string> names_, units_, slopes_, uncomputed_;
};

}  // namespace

pictures::Figure dynamics_figure(PlotSubject const& subject, WantedMove const& wanted) {
  subject.require_drawable();
  return DynamicsFigure(subject, wanted).make();
}

}  // namespace axisc
