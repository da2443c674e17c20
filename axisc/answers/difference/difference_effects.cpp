#include "analysis/motion/point.hpp"
#include "axisc/answers/certify/bound_quantity.hpp"
#include "axisc/answers/difference/difference_parts.hpp"
#include "axisc/answers/dynamics/driven_axis.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/labels.hpp"
#include "image/image_readings.hpp"

#include <cmath>

namespace axisc::says {

constexpr Sentence effect{"effect", "Wirkung"};
constexpr Sentence reading{"computed as (\"design\" of the settings)",
                           "gerechnet als (\"design\" der Einstellungen)"};
constexpr Sentence settling{"settling time (0.01 %)", "Einschwingzeit (0,01 %)"};
constexpr Sentence longer{"longer than {time}", "länger als {time}"};
constexpr Sentence gain{"gain at {frequency}", "Verstärkung bei {frequency}"};
constexpr Sentence corner{"deviation at a 90° corner, {feed}", "Abweichung an einer 90°-Ecke, {feed}"};
constexpr Sentence amplified{"proved: no setpoint is amplified more than",
                             "bewiesen: kein Sollwert wird mehr verstärkt als"};
constexpr Sentence at_rest{"proved: exactly at rest after", "bewiesen: exakt in Ruhe nach"};
constexpr Sentence not_proved{"not proved", "nicht bewiesen"};
constexpr Sentence slope{"slope", "Slope"};
constexpr Sentence default_slope{"{slope} (default)", "{slope} (Standardwert)"};
constexpr Sentence with_slope{"{what}, slope {slope}", "{what}, Slope {slope}"};
constexpr Sentence at_feed{"{distance} at F{feed}", "{distance} mit F{feed}"};
constexpr Sentence in_rapid{"{distance} in G00", "{distance} mit G00"};
constexpr Sentence not_computed{"not computed", "nicht berechnet"};
constexpr Sentence through_corner{"velocity through a 90° corner", "Geschwindigkeit durch eine 90°-Ecke"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

constexpr int digits = 4;

Value decibel(double magnitude) {
  constexpr double nothing = 1e-10;
  if (magnitude < nothing) return "< -200 dB";
  return rounded(std::round(2000 * std::log10(magnitude)) / 100, Unit::decibel, digits + 1);
}

/// Figures of one side.
struct EffectsOfSide {
  image::ChainFigures const& chain;
  image::ProvedBounds const& bounds;
  design::CycleTime cycle_time;
  double feed;

  [[nodiscard]] Quantity time(double cycles) const {
    return rounded(cycles * (cycle_time.seconds() * 1e3), Unit::millisecond, digits);
  }
  [[nodiscard]] Value settling() const {
    if (chain.settling_cycles) return time(static_cast<double>(*chain.settling_cycles));
    return Words(says::longer, {{"time", time(static_cast<double>(image::longest_settling))}});
  }
  [[nodiscard]] Value corner() const {
    return quantity_or({}, corner_deviation_um(chain, feed, cycle_time), Unit::micrometre,
                       Digits::significant(digits));
  }
  [[nodiscard]] Value amplification() const { return upper_bound(bounds.gain_high, digits); }
  [[nodiscard]] Value rest() const {
    if (!bounds.rest_cycles) return Words(says::not_proved);
    return upper_bound(static_cast<double>(*bounds.rest_cycles) * cycle_time.seconds() * 1e3, digits,
                       Unit::millisecond);
  }
  [[nodiscard]] std::vector<Field> data_fields() const {
    return {data("delay_ms", time(chain.delay_cycles)),
            data("overshoot_percent", chain.overshoot * 100),
            data("settling_ms", chain.settling_cycles ? settling() : Value()),
            data("corner_deviation_um", corner()),
            data("gain_high", exact(bounds.gain_high)),
            data("rest_cycles",
                 bounds.rest_cycles ? Value(exact(static_cast<double>(*bounds.rest_cycles))) : Value())};
  }
};

std::pair<EffectsOfSide, EffectsOfSide> sides_of(ShownDifference const& shown,
                                                 image::ChainDifference const& chain) {
  auto const& [before, after] = std::tie(shown.difference.before, shown.difference.after);
  return {{chain.before, chain.bounds_before, before.cycle_time, shown.feed_mm_per_min},
          {chain.after, chain.bounds_after, after.cycle_time, shown.feed_mm_per_min}};
}

void add_chain(Table& table, ShownDifference const& shown, image::ChainDifference const& chain) {
  auto const [before, after] = sides_of(shown, chain);
  add_difference(table, says::reading, image::readings_text(chain.reading_before),
                 image::readings_text(chain.reading_after));
  auto& rows = table.rows;
  rows.push_back(
      {Words(labels::delay), before.time(chain.before.delay_cycles), after.time(chain.after.delay_cycles)});
  rows.push_back({Words(says::settling), before.settling(), after.settling()});
  rows.push_back({Words(labels::step_overshoot), rounded(chain.before.overshoot * 100, Unit::percent, digits),
                  rounded(chain.after.overshoot * 100, Unit::percent, digits)});
  for (auto const& gain : chain.gains) {
    auto const frequency = rounded(gain.frequency.value, Unit::hertz, digits);
    rows.push_back(
        {Words(says::gain, {{"frequency", frequency}}), decibel(gain.before), decibel(gain.after)});
  }
  auto const feed = exact(shown.feed_mm_per_min, Unit::millimetre_per_minute);
  rows.push_back({Words(says::corner, {{"feed", feed}}), before.corner(), after.corner()});
  add_difference(table, says::amplified, before.amplification(), after.amplification());
  add_difference(table, says::at_rest, before.rest(), after.rest());
}

/// Units of the axis: of a rotary one ° stands for mm.
struct MotionUnits {
  explicit MotionUnits(machine::AxisType type) : is_translatory(type == machine::AxisType::translatory) {}
  bool is_translatory;
  Unit length = is_translatory ? Unit::millimetre : Unit::degree;
  Unit velocity = is_translatory ? Unit::millimetre_per_second : Unit::degree_per_second;
};

Words slope_of(AxisMotion const& motion) {
  auto const word = as_given(std::string(slope_name(motion.slope)));
  return motion.has_channel_list ? word : Words(says::default_slope, {{"slope", word}});
}

void add_motion(Table& table, MotionDifference const& motion, machine::AxisType type) {
  AxisMotion const& before = motion.before;
  AxisMotion const& after = motion.after;
  MotionUnits const units(type);
  WantedMove const move;
  auto const distance = exact(move.distance_mm, units.length);
  auto const seconds = [](double value) { return rounded(value, Unit::second, digits); };
  bool const is_one_slope = before.slope == after.slope && before.has_channel_list == after.has_channel_list;
  // Where both sides have the same slope, each row names it.
  auto const label = [&](Words what) {
    return is_one_slope ? Words(says::with_slope, {{"what", what}, {"slope", slope_of(after)}}) : what;
  };
  add_difference(table, says::slope, slope_of(before), slope_of(after));
  add_difference(table,
                 label(Words(says::at_feed, {{"distance", distance}, {"feed", exact(move.feed_mm_per_min)}})),
                 seconds(before.at_feed_s), seconds(after.at_feed_s));
  add_difference(table, label(Words(says::in_rapid, {{"distance", distance}})), seconds(before.in_rapid_s),
                 seconds(after.in_rapid_s));
  add_difference(table, says::through_corner, rounded(before.corner_velocity, units.velocity, digits),
                 rounded(after.corner_velocity, units.velocity, digits));
  if (before.uncomputed.empty() && after.uncomputed.empty()) return;
  table.rows.push_back({Words(says::not_computed), Names(before.uncomputed), Names(after.uncomputed)});
}

}  // namespace

Table effects_table(ShownDifference const& shown, AxisDifference const& axis) {
  auto table = side_table(shown, says::effect);
  if (axis.chain) add_chain(table, shown, *axis.chain);
  if (axis.motion) add_motion(table, *axis.motion, axis.after->type);
  return table;
}

Section motion_data(MotionDifference const& motion) {
  WantedMove const move;
  auto const side = [](std::string key, AxisMotion const& one) {
    return data_section(
        std::move(key),
        {data("slope", slope_name(one.slope)), data("channel_list", one.has_channel_list),
         data("at_feed_s", one.at_feed_s), data("in_rapid_s", one.in_rapid_s),
         data("corner_velocity_mm_s", one.corner_velocity), data("not_computed", Names(one.uncomputed))});
  };
  return {.key = "motion",
          .title = {},
          .blocks = {
              Facts{{data("distance_mm", move.distance_mm), data("feed_mm_per_min", move.feed_mm_per_min)}},
              side("before", motion.before), side("after", motion.after)}};
}

std::vector<Block> effects_data(ShownDifference const& shown, image::ChainDifference const& chain) {
  auto const [before, after] = sides_of(shown, chain);
  auto was = before.data_fields();
  auto is = after.data_fields();
  if (chain.reading_before != chain.reading_after) {
    was.push_back(data("design", image::readings_text(chain.reading_before)));
    is.push_back(data("design", image::readings_text(chain.reading_after)));
  }
  return {
      data_section("before", std::move(was)), data_section("after", std::move(is)),
      table_of("gains", data_columns({"frequency_hz", "before", "after"}), chain.gains, [](auto const& gain) {
        return Row{gain.frequency.value, gain.before, gain.after};
      })};
}

std::optional<double> corner_deviation_um(image::ChainFigures const& chain, double feed,
                                          design::CycleTime cycle_time) {
  if (!chain.corner_deviation) return std::nullopt;
  constexpr double seconds_per_minute = 60;
  return *chain.corner_deviation * feed * motion::um_per_mm / seconds_per_minute * cycle_time.seconds();
}

}  // namespace axisc
