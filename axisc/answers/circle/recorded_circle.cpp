#include "axisc/answers/circle/recorded_circle.hpp"

#include "analysis/circle/circle_fit.hpp"
#include "analysis/circle/external_turns.hpp"
#include "analysis/circle/recorded_turns.hpp"
#include "analysis/comparison/residual.hpp"
#include "analysis/motion/point.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence no_motion{
    "{file}: the axes do not move; record a circle of more than one turn",
    "{file}: die Achsen bewegen sich nicht; einen Kreis von mehr als einer Umdrehung aufzeichnen"};
constexpr Sentence no_circle{
    "{file}: the path at constant speed is not a circle; record more of the circle and less of what leads to "
    "it, and check the columns",
    "{file}: Die Bahn mit gleichmäßiger Geschwindigkeit ist kein Kreis; mehr vom Kreis und weniger vom Weg "
    "dorthin aufzeichnen und die Spalten prüfen"};
constexpr Sentence less_than_turn{
    "{file}: {degrees}° of the circle at constant speed, after the filters have settled; it takes 360°: "
    "program two turns",
    "{file}: {degrees}° des Kreises mit gleichmäßiger Geschwindigkeit, nachdem die Filter eingeschwungen "
    "sind; nötig sind 360°: zwei Umdrehungen programmieren"};
constexpr Sentence few_points{
    "{file}: {points} points in a turn, and {fewest} are needed; record every NC cycle, or lower the feed",
    "{file}: {points} Punkte in einer Umdrehung, nötig sind {fewest}; jeden NC-Zyklus aufzeichnen oder den "
    "Vorschub verringern"};
constexpr Sentence same_direction{
    "{file}: another recording has this direction already ({u} → {v}); give one turn of each direction",
    "{file}: Eine andere Aufzeichnung hat diese Richtung bereits ({u} → {v}); eine Umdrehung je Richtung "
    "angeben"};
constexpr Sentence other_radius{
    "{file}: the radii of the two directions are {first} mm and {second} mm; record both with one program",
    "{file}: Die Radien der beiden Richtungen sind {first} mm und {second} mm; beide mit einem Programm "
    "aufzeichnen"};
constexpr Sentence other_feed{
    "{file}: the feeds of the two directions are {first} and {second} mm/min; record both with one program",
    "{file}: Die Vorschübe der beiden Richtungen sind {first} und {second} mm/min; beide mit einem Programm "
    "aufzeichnen"};
constexpr Sentence other_centre{
    "{file}: the circles of the two directions are {distance} mm apart; record setpoints as well, or both "
    "circles in one place",
    "{file}: Die Kreise der beiden Richtungen liegen {distance} mm auseinander; auch Sollwerte aufzeichnen "
    "oder beide Kreise an einem Ort"};
constexpr Sentence other_radius_given{
    "{file}: a circle of {found} mm was recorded, which is not the {given} mm of --radius; check the radius "
    "and the columns",
    "{file}: aufgezeichnet ist ein Kreis von {found} mm, nicht von {given} mm wie --radius; den Radius und "
    "die Spalten prüfen"};
constexpr Sentence only_one_has_setpoints{
    "{file}: one recording has setpoints, the other has none; record both alike",
    "{file}: Eine Aufzeichnung hat Sollwerte, die andere keine; beide gleich aufzeichnen"};
constexpr Sentence less_than_turn_external{
    "{file}: {degrees}° in one direction; it takes 360°: record whole turns",
    "{file}: {degrees}° in einer Richtung; nötig sind 360°: ganze Umdrehungen aufzeichnen"};
constexpr Sentence needs_radius{
    "{file} has no setpoints, so the radius is not known; give it with --radius",
    "{file} hat keine Sollwerte, der Radius ist daher nicht bekannt; ihn mit --radius angeben"};
constexpr Sentence needs_feed{"{file} has no times, so the feed is not known; give it with --feed",
                              "{file} hat keine Zeiten, der Vorschub ist daher nicht bekannt; ihn mit --feed "
                              "angeben"};
constexpr Sentence modulo_axis{
    "axis {axis} is a modulo axis, whose position jumps: a circle cannot be measured with it",
    "Achse {axis} ist eine Moduloachse, deren Position springt: Ein Kreis ist mit ihr nicht messbar"};

}  // namespace axisc::says

namespace axisc {

namespace {

using circle::RecordedPath;
using circle::Sense;
using circle::Turn;

/// Of radius and speed, by which the directions may differ.
constexpr double largest_difference = 0.01;
/// Of a radius that only --radius tells: drives and filters never take more.
constexpr double largest_shrink = 0.1;
/// Of the radius: the centres of both directions, where no setpoint tells them.
constexpr double centre_difference = 0.002;

Wording number(double value) {
  return format_rounded(value, 5);
}

Failure refusal(SentenceRef sentence, std::string const& file, std::vector<Argument> arguments = {}) {
  arguments.push_back({"file", file});
  return Failure({sentence, std::move(arguments)}, csv_malformed);
}

Failure refusal(std::string const& file, circle::BadTurn const& bad, bool is_external) {
  using circle::TurnProblem;
  switch (bad.problem) {
    case TurnProblem::no_motion: return refusal(says::no_motion, file);
    case TurnProblem::no_circle: return refusal(says::no_circle, file);
    case TurnProblem::few_points:
      return refusal(
          says::few_points, file,
          {{"points", std::to_string(bad.points)}, {"fewest", std::to_string(circle::fewest_points)}});
    case TurnProblem::less_than_turn: break;
  }
  return refusal(is_external ? says::less_than_turn_external : says::less_than_turn, file,
                 {{"degrees", number(std::floor(bad.degrees))}});
}

/// The time between samples that all columns have, ms: whole NC cycles.
double common_step(RecordingFile const& file, std::vector<std::size_t> const& channels, double cycle_ms) {
  double cycles = 1;
  for (auto const channel : channels) {
    auto const& clock = file.recording.clocks[file.recording.channels[channel].clock];
    if (clock.is_counted || clock.problem) continue;
    cycles = std::max(cycles, std::round(recordings::sample_time(clock) / cycle_ms));
  }
  return cycles * cycle_ms;
}

/// Numbers that happen to be whole have the unit of the others.
void share_guess(std::vector<ColumnScale>& scales) {
  double largest = 0;
  for (auto const& scale : scales) {
    if (scale.is_guessed) largest = std::max(largest, scale.thousandths);
  }
  for (auto& scale : scales) {
    if (scale.is_guessed) scale.thousandths = largest;
  }
}

class CircleReader {
 public:
  CircleReader(CircleMachine const& machine, Plane const& plane, RecordedCircleQuestion const& question,
               double settling_s)
      : machine_(machine), plane_(plane), question_(question), settling_s_(settling_s) {}

  RecordedCircle read(std::vector<RecordingFile> const& files) {
    for (auto const& file : files) {
      auto turns = question_.is_external ? external(file) : positions_of(file);
      if (auto const* const bad = std::get_if<circle::BadTurn>(&turns)) {
        throw refusal(file.name, *bad, question_.is_external);
      }
      for (auto& turn : std::get<std::vector<Turn>>(turns)) add(file.name, std::move(turn));
    }
    auto const& last = files.back().name;
    if (found_.reference == CircleReference::least_squares) centre(last);
    compare_directions(last);
    return std::move(found_);
  }

 private:
  std::variant<std::vector<Turn>, circle::BadTurn> positions_of(RecordingFile const& file) {
    constexpr double microseconds = 1000;
    auto const chosen = circle_columns(machine_, plane_, file, question_.setpoints, question_.actuals);
    std::vector<ChosenColumn> columns = chosen.actuals;
    columns.insert(columns.end(), chosen.setpoints.begin(), chosen.setpoints.end());
    std::vector<std::size_t> channels;
    channels.reserve(columns.size());
    for (auto const& column : columns) channels.push_back(column.channel);
    double const step =
        common_step(file, channels, machine_.machine.cycle_time.microseconds() / microseconds);
    auto joined = cycles_of(file, channels, step);
    RecordedPath path;
    path.sample_time = step / microseconds;
    path.settling = settling_s_;
    std::array const targets{&path.actual_u, &path.actual_v, &path.setpoint_u, &path.setpoint_v};
    bool const is_first = found_.turns.empty();
    std::vector<ColumnScale> scales;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      scales.push_back(column_scale(file, columns[i], question_.units, machine_.image.axes[plane_.at(i % 2)],
                                    joined.signals[i], joined.gaps));
    }
    share_guess(scales);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      auto& signal = joined.signals[i];
      path.resolution =
          std::max(path.resolution, comparison::resolution(signal, joined.gaps) * scales[i].thousandths);
      *targets.at(i) = positions(std::move(signal), scales[i], 1).values();
      if (is_first) note(file, columns[i], scales[i], plane_.at(i % 2), i < 2 ? " actual" : " setpoint");
    }
    path.gaps = std::move(joined.gaps);
    auto const reference = chosen.setpoints.empty() ? CircleReference::least_squares
                           : chosen.is_filtered     ? CircleReference::filtered_setpoint
                                                    : CircleReference::setpoint;
    bool const has_none = reference == CircleReference::least_squares;
    if (!is_first && has_none != (found_.reference == CircleReference::least_squares)) {
      throw refusal(says::only_one_has_setpoints, file.name);
    }
    found_.reference = is_first ? reference : std::max(found_.reference, reference);
    return circle::recorded_turns(path);
  }

  void note(RecordingFile const& file, ChosenColumn const& column, ColumnScale const& scale, std::size_t axis,
            std::string const& what) {
    found_.signals.push_back(machine_.machine.axes[axis].name + what);
    found_.mapping.push_back(mapped_column(file, column, scale, false));
  }

  std::variant<std::vector<Turn>, circle::BadTurn> external(RecordingFile const& file) {
    bool const is_plain = !file.recording.is_named && file.recording.channels.size() == 2;
    std::array const channels{is_plain ? std::size_t{0} : file.channel_named("angle_deg"),
                              is_plain ? std::size_t{1} : file.channel_named("deviation_um")};
    std::array<std::vector<double>, 2> values;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      auto const& channel = file.recording.channels[channels.at(i)];
      if (channel.bad) fail_value(file, channels.at(i));
      values.at(i) = channel.values.values();
      if (found_.turns.empty()) {
        found_.signals.emplace_back(i == 0 ? "angle" : "deviation");
        found_.mapping.push_back(mapped_column(file, {.channel = channels.at(i), .by = FoundBy::name}));
      }
    }
    auto& [angles, deviations] = values;
    std::vector<double> known_angles, known_deviations;
    for (std::size_t i = 0; i < std::min(angles.size(), deviations.size()); ++i) {
      if (std::isnan(angles[i]) || std::isnan(deviations[i])) continue;
      known_angles.push_back(angles[i]);
      known_deviations.push_back(deviations[i]);
    }
    found_.is_external = true;
    found_.reference = CircleReference::least_squares;
    if (!question_.radius_mm) throw refusal(says::needs_radius, file.name);
    if (!question_.feed) throw refusal(says::needs_feed, file.name);
    auto turns =
        circle::external_turns(known_angles, known_deviations, *question_.radius_mm * motion::um_per_mm);
    if (auto* const all = std::get_if<std::vector<Turn>>(&turns)) {
      constexpr double seconds = 60;
      for (auto& turn : *all) turn.angular_speed = *question_.feed / seconds / *question_.radius_mm;
    }
    return turns;
  }

  [[nodiscard]] std::string const& name(std::size_t axis) const {
    return machine_.machine.axes[plane_.at(axis)].name;
  }

  void add(std::string const& file, Turn turn) {
    bool const is_there = std::any_of(found_.turns.begin(), found_.turns.end(),
                                      [&](Turn const& other) { return other.sense == turn.sense; });
    if (is_there) {
      throw refusal(says::same_direction, file,
                    {{"u", name(turn.sense == Sense::clockwise ? 1 : 0)},
                     {"v", name(turn.sense == Sense::clockwise ? 0 : 1)}});
    }
    found_.points = found_.turns.empty() ? turn.samples.size() : std::min(found_.points, turn.samples.size());
    found_.turns.push_back(std::move(turn));
  }

  /// Positions about the centre of the circle of all of them.
  void centre(std::string const& file) {
    if (!question_.radius_mm) throw refusal(says::needs_radius, file);
    std::vector<circle::Sample> all;
    for (auto& turn : found_.turns) all.insert(all.end(), turn.samples.begin(), turn.samples.end());
    auto const common = circle::fit_circle(all);
    double const given = *question_.radius_mm * motion::um_per_mm;
    if (!(std::abs(common.radius - given) <= largest_shrink * given)) {
      throw refusal(
          says::other_radius_given, file,
          {{"given", number(*question_.radius_mm)}, {"found", number(common.radius / motion::um_per_mm)}});
    }
    for (auto& turn : found_.turns) {
      auto const own = circle::fit_circle(turn.samples);
      double const distance = std::hypot(own.u - common.u, own.v - common.v);
      if (distance > centre_difference * common.radius) {
        throw refusal(says::other_centre, file, {{"distance", number(2 * distance / motion::um_per_mm)}});
      }
      turn.radius = own.radius;
      for (auto& sample : turn.samples) {
        sample.u -= common.u;
        sample.v -= common.v;
      }
    }
  }

  void compare_directions(std::string const& file) {
    constexpr double seconds = 60;
    auto& turns = found_.turns;
    auto const feed = [](Turn const& turn) {
      return turn.radius * turn.angular_speed * seconds / motion::um_per_mm;
    };
    auto const differ = [](double a, double b) {
      return std::abs(a - b) > largest_difference * std::max(a, b);
    };
    auto const& first = turns.front();
    auto const& last = turns.back();
    if (differ(first.radius, last.radius)) {
      throw refusal(says::other_radius, file,
                    {{"first", number(first.radius / motion::um_per_mm)},
                     {"second", number(last.radius / motion::um_per_mm)}});
    }
    if (differ(feed(first), feed(last))) {
      throw refusal(says::other_feed, file, {{"first", number(feed(first))}, {"second", number(feed(last))}});
    }
    found_.angular_speed = (first.angular_speed + last.angular_speed) / 2;
    found_.radius = found_.reference == CircleReference::least_squares
                        ? *question_.radius_mm * motion::um_per_mm
                        : (first.radius + last.radius) / 2;
    std::sort(turns.begin(), turns.end(), [](Turn const& a, Turn const& b) {
      return circle::sign_of(a.sense) > circle::sign_of(b.sense);
    });
    found_.deviations = circle::deviations_of(turns, found_.radius);
    if (turns.size() > 1) found_.causes = circle::causes_of(turns, found_.radius);
  }

  CircleMachine const& machine_;
  Plane const& plane_;
  RecordedCircleQuestion const& question_;
  double settling_s_;
  RecordedCircle found_;
};

}  // namespace

double RecordedCircle::feed_mm_per_min() const {
  constexpr double seconds = 60;
  return radius * angular_speed * seconds / motion::um_per_mm;
}

RecordedCircle recorded_circle(CircleMachine const& machine, Plane const& plane,
                               std::vector<RecordingFile> const& files,
                               RecordedCircleQuestion const& question, double settling_s) {
  for (auto const axis : plane) {
    if (!question.is_external && modulo_range(machine.image.axes[axis])) {
      throw Failure({says::modulo_axis, {{"axis", machine.machine.axes[axis].name}}}, csv_malformed);
    }
  }
  return CircleReader(machine, plane, question, settling_s).read(files);
}

}  // namespace axisc
