#include "axisc/answers/circle/circle_answer.hpp"

#include "axisc/answers/circle/circle_tables.hpp"
#include "axisc/answers/execution/mapping_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence title{"circular test, NC cycle time {cycle_time}",
                         "Kreisformtest, NC-Zykluszeit {cycle_time}"};
constexpr Sentence one_circle{"{u}/{v}, r {radius}, F {feed}", "{u}/{v}, r {radius}, F {feed}"};
constexpr Sentence definitions{"G, G(b), D and F after ISO 230-4:2005, as secondary sources give it",
                               "G, G(b), D und F nach ISO 230-4:2005, wie Sekundärquellen es wiedergeben"};
constexpr Sentence filters_are_on{
    "filters are on, as after #FILTER ON or #VIB GUARD ON; drives are not predicted",
    "die Filter sind an, wie nach #FILTER ON oder #VIB GUARD ON; Antriebe werden "
    "nicht vorhergesagt"};
constexpr Sentence keeps{"{deviation} keeps the tolerance of {tolerance}",
                         "{deviation} hält die Toleranz von {tolerance} ein"};
constexpr Sentence exceeds{"{deviation} exceeds the tolerance of {tolerance}",
                           "{deviation} überschreitet die Toleranz von {tolerance}"};
constexpr Sentence round{"the filters leave the circle round", "die Filter lassen den Kreis rund"};
constexpr Sentence inseparable{
    "backlash and friction cannot be told apart; larger radius or lower feed",
    "Lose und Reibung sind nicht zu unterscheiden; größerer Radius oder kleinerer Vorschub"};
constexpr Sentence one_direction{
    "one direction: G and F only; record the other direction as well for D, G(b) and the causes",
    "eine Richtung: nur G und F; für D, G(b) und die Ursachen auch die andere Richtung aufzeichnen"};
constexpr Sentence few{
    "{points} points in a turn: spikes may lie between them; from 360 on nothing is missed",
    "{points} Punkte in einer Umdrehung: Spitzen können dazwischen liegen; ab 360 fehlt nichts"};
constexpr Sentence no_setpoint{
    "there are no setpoints: F is about the least squares centre, and a wrong centre is not seen",
    "es gibt keine Sollwerte: F gilt um den Mittelpunkt nach kleinsten Quadraten, ein falscher Mittelpunkt "
    "ist nicht zu sehen"};
constexpr Sentence filtered_setpoint{
    "the setpoints are those after the filters: what these do is not in the recorded figures",
    "die Sollwerte sind die nach den Filtern: Was diese tun, ist nicht in den aufgezeichneten Kenngrößen"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;
using circle::Deviations;

constexpr std::size_t enough_points = 360;
/// Of the largest cause, and in µm: smaller ones need no remedy.
constexpr double notable_share = 0.1;
constexpr double notable_um = 0.1;

/// By Causes::spikes.
constexpr std::array<std::string_view, 8> spike_places{"ccw u+", "ccw v+", "ccw u-", "ccw v-",
                                                       "cw u+",  "cw v+",  "cw u-",  "cw v-"};
/// By CircleReference.
constexpr std::array<std::string_view, 3> references{"setpoint", "filtered-setpoint", "least-squares"};

Facts deviation_data(Deviations const& of) {
  return {{data("circular_deviation_um", of.counterclockwise, "ccw"),
           data("circular_deviation_um", of.clockwise, "cw"),
           data("bidirectional_circular_deviation_um", of.bidirectional),
           data("mean_radial_deviation_um", of.mean_radial),
           data("radial_deviation_um", of.radial_max, "max"),
           data("radial_deviation_um", of.radial_min, "min"), data("hysteresis_um", of.hysteresis)}};
}

Section prediction_data(CircleCase const& one) {
  auto filters = filters_table(one);
  auto causes = data_section("causes", {data("radius_um", one.predicted.radius_deviation()),
                                        data("gain_difference", one.predicted.gain_difference()),
                                        data("delay_difference_us", one.delay_difference_s() * millionths)});
  causes.blocks.emplace_back(std::move(filters));
  return {.key = "prediction",
          .title = {},
          .blocks = {deviation_data(one.deviations), std::move(causes)},
          .audience = Audience::programs};
}

Section causes_data(RecordedCircle const& recorded) {
  auto const& found = *recorded.causes;
  std::vector<Field> fields{
      data("radius_um", found.radius),
      data("centre_um", Numbers{{found.centre[0], found.centre[1]}}),
      data("gain_difference", found.gain_difference),
      data("squareness_um_per_m", found.squareness * millionths),
      data("delay_difference_us", found.delay_difference / recorded.angular_speed * millionths),
      data("backlash_um",
           found.is_separable ? Value(Numbers{{found.backlash[0], found.backlash[1]}}) : Value()),
      data("backlash_uncertainty_um",
           Numbers{{found.backlash_uncertainty[0], found.backlash_uncertainty[1]}})};
  for (std::size_t i = 0; i < found.spikes.size(); ++i) {
    fields.push_back(data("spike_um", found.spikes.at(i), std::string(spike_places.at(i))));
  }
  fields.push_back(data("unexplained_rms_um", found.unexplained_rms));
  return data_section("causes", std::move(fields));
}

Section recording_data(RecordedCircle const& recorded) {
  Section section{
      .key = "recording",
      .title = {},
      .blocks = {Facts{{data("points_per_turn", recorded.points),
                        data("reference", references.at(static_cast<std::size_t>(recorded.reference))),
                        data("external", recorded.is_external)}},
                 deviation_data(recorded.deviations)},
      .audience = Audience::programs};
  auto const& causes = recorded.causes;
  section.blocks.emplace_back(
      Facts{{data("backlash_and_friction_separable", causes ? Value(causes->is_separable) : Value())}});
  if (causes) {
    section.blocks.emplace_back(causes_data(recorded));
  } else {
    section.blocks.emplace_back(Facts{{data("causes", {})}});
  }
  return section;
}

/// What a reader has to know about the recording.
void add_remarks(std::vector<Block>& blocks, RecordedCircle const& recorded) {
  if (recorded.turns.size() < 2) blocks.emplace_back(Paragraph{says::one_direction});
  if (recorded.points < enough_points) {
    blocks.emplace_back(Paragraph{Words(says::few, {{"points", recorded.points}})});
  }
  if (recorded.reference == CircleReference::least_squares) blocks.emplace_back(Paragraph{says::no_setpoint});
  if (recorded.reference == CircleReference::filtered_setpoint) {
    blocks.emplace_back(Paragraph{says::filtered_setpoint});
  }
  if (recorded.causes && !recorded.causes->is_separable) blocks.emplace_back(Paragraph{says::inseparable});
}

void add_remedies(std::vector<Block>& blocks, CircleCase const& one) {
  auto const causes = causes_by_size(one);
  if (causes.empty()) return;
  double const least = std::max(notable_um, notable_share * causes.front().size_um);
  if (!one.recorded && causes.front().size_um < least) blocks.emplace_back(Paragraph{says::round});
  for (auto const& cause : causes) {
    if (cause.size_um >= least && cause.remedy) blocks.emplace_back(Paragraph{*cause.remedy});
  }
}

}  // namespace

Words circle_title(CircleCase const& one) {
  return {says::one_circle,
          {{"u", one.axes[0]},
           {"v", one.axes[1]},
           {"radius", rounded(one.radius_mm, Unit::millimetre, 6)},
           {"feed", rounded(one.feed_mm_per_min, Unit::millimetre_per_minute, 5)}}};
}

std::vector<Block> circle_blocks(CircularTest const& test, CircleCase const& one) {
  std::vector<Block> blocks{prediction_data(one)};
  if (one.recorded) {
    blocks.emplace_back(recording_data(*one.recorded));
    blocks.emplace_back(mapping_table(one.recorded->signals, one.recorded->mapping));
  }
  blocks.emplace_back(deviations_table(one));
  blocks.emplace_back(causes_table(one));
  auto filters = filters_table(one);
  filters.audience = Audience::people;
  if (!filters.rows.empty()) blocks.emplace_back(std::move(filters));
  if (test.tolerance_um) {
    blocks.emplace_back(Facts{{data("keeps_tolerance", test.keeps(one))}});
    blocks.emplace_back(Paragraph{Words(test.keeps(one) ? says::keeps : says::exceeds,
                                        {{"deviation", fixed(one.deviation(), Unit::micrometre, 2)},
                                         {"tolerance", exact(*test.tolerance_um, Unit::micrometre)}})});
  }
  if (one.recorded) add_remarks(blocks, *one.recorded);
  add_remedies(blocks, one);
  return blocks;
}

Document circle_answer(CircularTest const& test) {
  auto const cycle_time = exact(test.cycle_time.microseconds(), Unit::microsecond);
  Sections circles{.key = "circles", .items = {}};
  for (auto const& one : test.cases) {
    circles.items.push_back(
        {.key = {},
         .title = circle_title(one),
         .blocks = circle_blocks(test, one),
         .identity = {data("plane", one.axes[0] + one.axes[1]), data("axes", Names{one.axes[0], one.axes[1]}),
                      data("feed_mm_per_min", one.feed_mm_per_min), data("radius_mm", one.radius_mm)}});
  }
  return {.version = 1,
          .title = Words(says::title, {{"cycle_time", cycle_time}}),
          .blocks = {Facts{{data("cycle_time_us", cycle_time), data("tolerance_um", test.tolerance_um)}},
                     Paragraph{says::filters_are_on}, Paragraph{says::definitions}, std::move(circles)},
          .csv_table = "circles"};
}

}  // namespace axisc
