#include "axisc/answers/contour/passage_blocks.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"

#include <optional>
#include <string_view>

namespace axisc::says {

constexpr Sentence passage_title{"corner of {angle}, as the control passes it (a reading): {slope}",
                                 "Ecke von {angle}, wie die Steuerung sie fährt (eine Lesart): {slope}"};
constexpr Sentence passage_feed{"F", "F"};
constexpr Sentence through{"through the corner", "durch die Ecke"};
constexpr Sentence braking{"braking", "Bremsen"};
constexpr Sentence over{"over", "über"};
constexpr Sentence accelerating{"accelerating", "Beschleunigen"};

constexpr Sentence slowed{
    "axis {axis} may change its velocity by {step} from one cycle to the next: {reason}",
    "Achse {axis} darf ihre Geschwindigkeit von einem Zyklus zum nächsten um {step} ändern: {reason}"};
constexpr Sentence by_step{"with STEP that is a T, acceleration times cycle time",
                           "mit STEP ist das a T, Beschleunigung mal Zykluszeit"};
constexpr Sentence by_weight{"that is {weight} ‰ of a T by P-AXIS-00013 (`a_trans_weight`)",
                             "das sind {weight} ‰ von a T nach P-AXIS-00013 (`a_trans_weight`)"};
constexpr Sentence by_weight_and_factor{
    "that is {weight} ‰ of a T by P-AXIS-00013 (`a_trans_weight`) and ACC_FACT",
    "das sind {weight} ‰ von a T nach P-AXIS-00013 (`a_trans_weight`) und ACC_FACT"};
constexpr Sentence by_jerk{
    "P-AXIS-00013 (`a_trans_weight`) is 0, which gives a T²/tr, what the jerk does in a cycle",
    "P-AXIS-00013 (`a_trans_weight`) ist 0, das ergibt a T²/tr, was der Ruck in einem Zyklus bewirkt"};
constexpr Sentence by_missing_jerk{
    "P-CHAN-00117 is 2 and P-AXIS-00339 (`j_trans_c0`) is 0, which gives a T²/tr, what the jerk does in a "
    "cycle",
    "P-CHAN-00117 ist 2 und P-AXIS-00339 (`j_trans_c0`) ist 0, das ergibt a T²/tr, was der Ruck in einem "
    "Zyklus bewirkt"};
constexpr Sentence by_curve_weight{
    "by P-AXIS-00154 (`r_trans_weight`), which P-AXIS-00013 follows in this reading",
    "nach P-AXIS-00154 (`r_trans_weight`), dem P-AXIS-00013 in dieser Lesart folgt"};
constexpr Sentence by_corner_jerk{"by P-AXIS-00339 (`j_trans_c0`), as P-CHAN-00117 is 2",
                                  "nach P-AXIS-00339 (`j_trans_c0`), weil P-CHAN-00117 2 ist"};
constexpr Sentence nearly_stops{
    "the path nearly stops there, so that the filters bend the corner by {passed} instead of {full}",
    "die Bahn hält dort fast an; die Filter verbiegen die Ecke darum um {passed} statt {full}"};
constexpr Sentence slower_line{
    "the control brakes only to the velocity that the second line allows",
    "die Steuerung bremst nur auf die Geschwindigkeit, die die zweite Gerade zulässt"};
constexpr Sentence at_full_feed{"the control passes this corner without braking",
                                "diese Ecke fährt die Steuerung, ohne zu bremsen"};
constexpr Sentence too_long{
    "the filters take more than {cycles} cycles: how they bend the corner on this path is not calculated",
    "die Filter brauchen mehr als {cycles} Zyklen: wie sie die Ecke auf dieser Bahn verbiegen, wird nicht "
    "berechnet"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::units_per_mm;
using namespace presentation;

/// Velocities below this share of the feed are nearly a stop.
constexpr double nearly_a_stop = 0.01;

/// The parameter that decides, as planning/axis_mode.cpp applies them.
Words reason_of(GroupContour const& group, std::size_t axis) {
  auto const& dynamics = group.dynamics;
  auto const& channel = dynamics.channel;
  auto const& own = dynamics.axes[axis];
  double const weight = own.acceleration_transition_weight;
  bool const weighs = channel.transition_mode != 2;
  if (channel.slope == machine::Slope::step) return says::by_step;
  if (!weighs && own.corner_jerk > 0) return says::by_corner_jerk;
  bool const follows_curve = channel.transition_mode == 0 &&
                             dynamics.readings.weights == machine::TransitionReading::a_follows_r &&
                             own.curvature_transition_weight > weight;
  if (follows_curve) return says::by_curve_weight;
  if (!weighs) return says::by_missing_jerk;
  if (weight > 0) {
    SentenceRef const by = group.acceleration_factor == 1 ? says::by_weight : says::by_weight_and_factor;
    return {by, {{"weight", exact(weight * group.acceleration_factor)}}};
  }
  return says::by_jerk;
}

Quantity velocity(double units_per_cycle, design::CycleTime cycle_time) {
  return rounded(units_per_cycle / (units_per_mm * cycle_time.seconds()), Unit::millimetre_per_second, 4);
}

Row row_of(PassedFeed const& passed, GroupContour const& group) {
  auto const cycle_time = group.dynamics.cycle_time;
  auto const& passage = passed.passage;
  Row row{exact(passed.feed_mm_per_min)};
  for (auto& value : passage_figures(passage, cycle_time)) row.push_back(std::move(value));
  row.push_back(passage.slowed_by ? Value(group.axes[*passage.slowed_by]) : Value());
  row.push_back(passage.slowed_by ? Value(velocity(passage.step, cycle_time)) : Value());
  return row;
}

}  // namespace

Row passage_figures(motion::CornerPassage const& passage, design::CycleTime cycle_time) {
  double const milliseconds = cycle_time.seconds() * 1e3;
  Row figures{velocity(passage.velocity, cycle_time)};
  for (auto const* const leg : {&passage.before, &passage.behind}) {
    figures.emplace_back(fixed(leg->ramp_time * milliseconds, Unit::millisecond, 1));
    figures.emplace_back(rounded(leg->ramp_way / units_per_mm, Unit::millimetre, 4));
  }
  return figures;
}

std::vector<Column> passage_columns() {
  return {column("velocity_mm_s", says::through, Unit::millimetre_per_second),
          column("braking_ms", says::braking, Unit::millisecond),
          column("braking_mm", says::over, Unit::millimetre),
          column("accelerating_ms", says::accelerating, Unit::millisecond),
          column("accelerating_mm", says::over, Unit::millimetre)};
}

std::vector<Block> passage_blocks(GroupContour const& group, ContourRequest const& wanted) {
  auto const& channel = group.dynamics.channel;
  Table table{.key = "corner_passage",
              .columns = {head_column("feed_mm_per_min", says::passage_feed, Unit::millimetre_per_minute)}};
  for (auto& one : passage_columns()) table.columns.push_back(std::move(one));
  for (auto& one : data_columns({"slowed_by_axis", "axis_step_mm_s"})) {
    table.columns.push_back(std::move(one));
  }
  for (auto const& passed : group.passages) table.rows.push_back(row_of(passed, group));
  Section section{.key = {},
                  .title = Words(says::passage_title, {{"angle", exact(wanted.angle_deg, Unit::degree)},
                                                       {"slope", slope_words(channel)}}),
                  .blocks = {Facts{{data("slope", slope_name(channel.slope)),
                                    data("channel_list", channel.is_from_list)}}}};
  auto const tell = [&section](Words words) { section.blocks.emplace_back(Paragraph{std::move(words)}); };
  auto const& passage = group.passages.front().passage;
  auto const& first = group.cases.front();
  auto const step = table.rows.front().back();
  section.blocks.emplace_back(std::move(table));
  if (!passage.slowed_by) {
    tell(passage.before.ramp.empty() ? SentenceRef(says::at_full_feed) : says::slower_line);
  } else {
    tell({says::slowed,
          {{"axis", group.axes[*passage.slowed_by]},
           {"step", step},
           {"reason", reason_of(group, *passage.slowed_by)}}});
  }
  if (!first.passed_corner) {
    tell({says::too_long, {{"cycles", exact(motion::longest_passage_reach)}}});
  } else if (passage.velocity < nearly_a_stop * passage.before.velocity && first.corner.deviation > 0) {
    auto const micrometres = [](double units) {
      return fixed(units / motion::units_per_um, Unit::micrometre, 3);
    };
    tell({says::nearly_stops,
          {{"passed", micrometres(first.passed_corner->deviation)},
           {"full", micrometres(first.corner.deviation)}}});
  }
  return {std::move(section)};
}

}  // namespace axisc
