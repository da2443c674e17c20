#include "axisc/answers/certify/certified_axis.hpp"

#include "axisc/answers/certify/bound_quantity.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/files/image_file.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence stable{"stable", "stabil"};
constexpr Sentence poles{"poles within {radius}", "Pole innerhalb von {radius}"};
constexpr Sentence amplified{"no setpoint is amplified more than {high} times; some is {low} times",
                             "kein Sollwert wird mehr als {high}-fach verstärkt, mancher {low}-fach"};
constexpr Sentence amplified_at_most{"no setpoint is amplified more than {high} times",
                                     "kein Sollwert wird mehr als {high}-fach verstärkt"};
constexpr Sentence at_most{"at most {overshoot}", "höchstens {overshoot}"};
constexpr Sentence arithmetic{"arithmetic", "Rechnung"};
constexpr Sentence apart{
    "within {velocity} at most {error} units and half a last digit off the exact filter",
    "bis {velocity} höchstens {error} Einheiten und eine halbe letzte Stelle neben dem exakten Filter"};
constexpr Sentence apart_per_increment{
    "at most {error} of the largest increment and half a last digit off the exact filter",
    "höchstens {error} des größten Inkrements und eine halbe letzte Stelle neben dem exakten Filter"};
constexpr Sentence not_bounded{
    "not bounded: a filter is too slow, or too close to half the sampling rate",
    "nicht beschränkt: ein Filter ist zu langsam oder zu nahe an der halben Abtastrate"};
constexpr Sentence overflow{"overflow", "Überlauf"};
constexpr Sentence impossible{"impossible: states below {increments} increments, {positions} positions",
                              "unmöglich: Zustände unter {increments} Inkrementen, {positions} Positionen"};
constexpr Sentence standstill{"standstill", "Stillstand"};
constexpr Sentence exact_rest{"output == setpoint exactly after {cycles} ({time}), for good",
                              "nach {cycles} ({time}) Ausgang == Sollwert, exakt und dauerhaft"};
constexpr Sentence exact_zero{"every state exactly 0 after {cycles} ({time}), for good",
                              "nach {cycles} ({time}) jeder Zustand 0, exakt und dauerhaft"};
constexpr Sentence not_claimed{
    "not claimed: a filter is too slow, or too close to half the sampling rate",
    "nicht behauptet: ein Filter ist zu langsam oder zu nahe an der halben Abtastrate"};
constexpr Sentence changes{"changes of kernels", "Kernwechsel"};
constexpr Sentence added{"in motion add at most {velocity} and {acceleration}, in {cycles}",
                         "in Bewegung höchstens {velocity} und {acceleration} zusätzlich, in {cycles}"};
constexpr Sentence too_rough{"FALSE: in motion they add up to {velocity} and {acceleration}",
                             "FALSCH: in Bewegung bis zu {velocity} und {acceleration} zusätzlich"};
constexpr Sentence supervision{"supervision", "Überwachung"};
constexpr Sentence implausible{"IMPLAUSIBLE above {limit}; never with setpoints within {velocity}",
                               "IMPLAUSIBLE über {limit}; nie mit Sollwerten innerhalb von {velocity}"};
constexpr Sentence unfiltered{"no filter: setpoints pass unchanged",
                              "kein Filter: Sollwerte gehen unverändert durch"};
constexpr Sentence chain{"chain", "Kette"};
constexpr Sentence setpoints{"setpoints", "Sollwerte"};
constexpr Sentence with_kernel{"setpoints, kernel {kernel}", "Sollwerte, Kern {kernel}"};
constexpr Sentence interface { "additional interface", "Zusatzschnittstelle" };
constexpr Sentence stage{"stage {stage}", "Stufe {stage}"};
constexpr Sentence distance{"distance", "Abstand"};
constexpr Sentence roundings{"rounding per increment", "Rundung je Inkrement"};
constexpr Sentence rest{"rest after", "Ruhe nach"};
constexpr Sentence claim{"claim", "Aussage"};
constexpr Sentence is_true{"verified", "bestätigt"};
constexpr Sentence is_false{"FALSE: {field}", "FALSCH: {field}"};
constexpr Sentence not_in_image{"not in the image", "nicht im Abbild"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

struct AxisUnits {
  Unit velocity, acceleration;
};

AxisUnits units_of(image::ImageAxis const& axis) {
  if (axis.type == 1) return {Unit::millimetre_per_second, Unit::millimetre_per_second_squared};
  return {Unit::degree_per_second, Unit::degree_per_second_squared};
}

bool is_bounded(image::BoundRecord const& bound) {
  return (bound.flags & axim_bound_majorant) == 0 || bound.state_increment > 0;
}

Words rest_words(image::BoundRecord const& bound, double final_value, design::CycleTime cycle_time) {
  if (bound.rest_cycles == 0) return says::not_claimed;
  auto const cycles = static_cast<double>(bound.rest_cycles);
  return {final_value == 1 ? says::exact_rest : says::exact_zero,
          {{"cycles", upper_bound(cycles, 6, Unit::cycle)},
           {"time", upper_bound(cycles * cycle_time.seconds(), 3, Unit::second)}}};
}

Words arithmetic_words(image::ImageAxis const& axis, image::BoundRecord const& bound) {
  if (!is_bounded(bound)) return says::not_bounded;
  if (axis.velocity_limit > 0) {
    return {says::apart,
            {{"velocity", upper_bound(axis.velocity_limit / 1e3, 5, units_of(axis).velocity)},
             {"error", upper_bound(bound.limit_error, 2)}}};
  }
  return {says::apart_per_increment, {{"error", upper_bound(bound.rounding_increment, 2)}}};
}

Words change_words(image::ImageAxis const& axis, image::CheckedChange const& change) {
  auto const [velocity, acceleration] = units_of(axis);
  return {
      change.holds ? says::added : says::too_rough,
      {{"velocity", upper_bound(change.bound.velocity * axis.velocity_limit / 1e3, 3, velocity)},
       {"acceleration", upper_bound(change.bound.acceleration * axis.acceleration_limit, 3, acceleration)},
       {"cycles", exact(change.bound.cycles, Unit::cycle)}}};
}

double final_value(image::ImageAxis const& axis) {
  double value = 1;
  for (auto const& filter : axis.filters) value *= filter.design.dc_gain;
  return value;
}

/// What people read about the setpoint chain without a kernel.
Facts sentences(image::ImageContents const& image, std::size_t index, image::BoundRecord const& bound,
                double largest_gain, image::CheckedBounds const& checked) {
  auto const& axis = image.axes[index];
  bool const is_tight = (bound.flags & axim_bound_majorant) == 0;
  Facts facts{
      {shown(says::stable, Words(says::poles, {{"radius", upper_bound(bound.radius_high, 9)}})),
       shown(labels::gain,
             Words(is_tight ? says::amplified : says::amplified_at_most,
                   {{"high", upper_bound(bound.gain_high, 8)}, {"low", lower_bound(bound.gain_low, 8)}})),
       shown(labels::overshoot, Words(says::at_most, {{"overshoot", upper_bound(bound.overshoot_high * 100, 5,
                                                                                Unit::percent)}})),
       shown(says::arithmetic, arithmetic_words(axis, bound))}};
  if (bound.state_increment > 0) {
    facts.fields.push_back(shown(
        says::overflow, Words(says::impossible, {{"increments", upper_bound(bound.state_increment, 2)},
                                                 {"positions", upper_bound(bound.state_position, 2)}})));
  }
  facts.fields.push_back(shown(says::standstill, rest_words(bound, final_value(axis), image.cycle_time)));
  auto const& change = checked.changes[index];
  if (change.bound.cycles > 0) facts.fields.push_back(shown(says::changes, change_words(axis, change)));
  if (checked.is_in_image && axis.velocity_limit > 0) {
    double const v = axis.velocity_limit / 1e3;
    Unit const unit = units_of(axis).velocity;
    facts.fields.push_back(
        shown(says::supervision,
              Words(says::implausible, {{"limit", upper_bound((largest_gain + 0.25) * v, 4, unit)},
                                        {"velocity", upper_bound(v, 5, unit)}})));
  }
  return facts;
}

Words chain_name(image::BoundRecord const& bound) {
  if (bound.port == axim_port_interface) return says::interface;
  if (bound.port == axim_port_velocity) return {says::stage, {{"stage", exact(bound.stage)}}};
  if (bound.kernel == AXIM_NONE) return says::setpoints;
  return {says::with_kernel, {{"kernel", exact(bound.kernel)}}};
}

Value verdict(image::CheckedBound const& record) {
  if (!record.claimed) return Symbol{"not in the image", says::not_in_image};
  if (record.failing == image::Claim::none) return Symbol{"verified", says::is_true};
  std::string_view const field = name_of(record.failing);
  return Symbol{"false", Words(says::is_false, {{"field", std::string(field)}})};
}

std::vector<Field> row(image::CheckedBound const& record) {
  auto const& bound = record.claimed ? *record.claimed : record.computed;
  auto const number = [](double value) { return Value(exact(value)); };
  auto const rounding = is_bounded(bound) ? upper_bound(bound.rounding_increment, 2) : Value();
  bool const fails = record.failing != image::Claim::none;
  return {shown(says::chain, chain_name(bound)),
          data("port", port_name(static_cast<Port>(bound.port))),
          data("kernel", bound.kernel == AXIM_NONE ? Value() : Value(exact(bound.kernel))),
          data("stage", bound.port == axim_port_velocity ? Value(exact(bound.stage)) : Value()),
          data("is_majorant", (bound.flags & axim_bound_majorant) != 0),
          data("cycles", exact(bound.cycles)),
          data("gain_low", number(bound.gain_low)),
          data("gain_high", number(bound.gain_high)),
          shown(labels::gain, upper_bound(bound.gain_high, 8)),
          data("overshoot_high", number(bound.overshoot_high)),
          shown(labels::overshoot, upper_bound(bound.overshoot_high * 100, 4, Unit::percent)),
          data("distance_high", number(bound.distance_high)),
          shown(says::distance, upper_bound(bound.distance_high, 5, Unit::cycle)),
          data("radius_high", number(bound.radius_high)),
          data("rounding_increment", number(bound.rounding_increment)),
          shown(says::roundings, rounding),
          data("rounding_position", number(bound.rounding_position)),
          data("state_increment", number(bound.state_increment)),
          data("state_position", number(bound.state_position)),
          data("rest_cycles", exact(static_cast<double>(bound.rest_cycles))),
          shown(says::rest, bound.rest_cycles == 0
                                ? Value(Nothing{})
                                : Value(exact(static_cast<double>(bound.rest_cycles), Unit::cycle))),
          data("limit_error", number(bound.limit_error)),
          {"verdict", says::claim, verdict(record)},
          data("false_field", fails ? Value(std::string_view(name_of(record.failing))) : Value())};
}

}  // namespace

Section certified_axis(image::ImageContents const& image, std::size_t axis,
                       image::CheckedBounds const& checked) {
  Table table{.key = "records"};
  image::BoundRecord const* alone = nullptr;
  double largest_gain = 0;
  for (auto const& record : checked.records) {
    auto const& bound = record.computed;
    if (bound.axis != axis) continue;
    add_row(table, row(record));
    if (bound.port != axim_port_setpoint) continue;
    if (bound.kernel == AXIM_NONE) alone = &bound;
    largest_gain = std::max(largest_gain, bound.gain_high);
  }
  auto const& change = checked.changes[axis];
  Section section{.key = {},
                  .title = Words(labels::one_axis, {{"axis", axis_label(image, axis)}}),
                  .blocks = {},
                  .identity = {data("name", axis_label(image, axis))}};
  if (table.rows.empty()) section.blocks.emplace_back(Paragraph{says::unfiltered});
  if (alone != nullptr) section.blocks.emplace_back(sentences(image, axis, *alone, largest_gain, checked));
  section.blocks.emplace_back(
      data_section("changes", {data("velocity_share", exact(change.bound.velocity)),
                               data("acceleration_share", exact(change.bound.acceleration)),
                               data("cycles", exact(change.bound.cycles)), data("verified", change.holds)}));
  section.blocks.emplace_back(std::move(table));
  return section;
}

}  // namespace axisc
