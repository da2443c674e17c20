#include "axisc/answers/circle/circle_answer.hpp"
#include "axisc/answers/circle/circle_tables.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence gain{"gain {u} - {v}", "Verstärkung {u} - {v}"};
constexpr Sentence squareness{"squareness", "Rechtwinkligkeit"};
constexpr Sentence cross_term{"cross term", "Kreuzterm"};
constexpr Sentence spike{"reversal {axis}", "Umkehr {axis}"};

constexpr Sentence filters_shrink{
    "the filters make the radius smaller by {size}, with the square of the feed; most of it is {filter} of "
    "{axis}: lower the feed, or shorten that filter in both axes",
    "die Filter verkleinern den Radius um {size}, mit dem Quadrat des Vorschubs; das meiste davon {filter} "
    "von {axis}: Vorschub verringern oder diesen Filter in beiden Achsen kürzen"};
constexpr Sentence radius_rest{
    "the radius is off by {size}, of which the filters explain {filters}; the rest comes from the drives: "
    "check feedforward and Kv of both axes, and the measuring systems",
    "der Radius weicht um {size} ab, davon erklären die Filter {filters}; der Rest kommt von den Antrieben: "
    "Vorsteuerung und Kv beider Achsen und die Messsysteme prüfen"};
constexpr Sentence radius_after_filters{
    "the radius is off by {size} from setpoints after the filters: check feedforward and Kv of both axes",
    "der Radius weicht um {size} von Sollwerten nach den Filtern ab: Vorsteuerung und Kv beider Achsen "
    "prüfen"};
constexpr Sentence filters_gain{
    "{axis} passes less of the circle than the other axis: use the same filters in both",
    "{axis} gibt weniger vom Kreis weiter als die andere Achse: in beiden dieselben Filter verwenden"};
constexpr Sentence gain_recorded{
    "{axis} moves less than the other axis, by {size} of the diameter: check scale and pitch of the "
    "measuring systems, and feedforward",
    "{axis} bewegt sich um {size} des Durchmessers weniger als die andere Achse: Skalierung und Steigung der "
    "Messsysteme und die Vorsteuerung prüfen"};
constexpr Sentence filters_delay{
    "{late} arrives {time} later than {early} (AX4011), which bends the circle by {size} at ±45°, turned "
    "with the direction: use the same filters in both axes, or a time delay (`filter_fir.type 4`) in {early}",
    "{late} kommt {time} später an als {early} (AX4011), das biegt den Kreis um {size} unter ±45°, mit der "
    "Richtung gedreht: in beiden Achsen dieselben Filter verwenden oder eine Zeitverzögerung "
    "(`filter_fir.type 4`) in {early}"};
constexpr Sentence delay_recorded{
    "{late} arrives {time} later than {early}, which bends the circle by {size} at ±45°, turned with the "
    "direction; the lists explain {filters} of {axes}: what is left are Kv, feedforward and filters of the "
    "drives",
    "{late} kommt {time} später an als {early}, das biegt den Kreis um {size} unter ±45°, mit der Richtung "
    "gedreht; die Listen erklären {filters} von {axes}: Der Rest sind Kv, Vorsteuerung und Filter der "
    "Antriebe"};
constexpr Sentence delay_after_filters{
    "after the filters, {late} arrives {time} later than {early}, which bends the circle by {size} at ±45°, "
    "turned with the direction: check Kv, feedforward and filters of the drives",
    "nach den Filtern kommt {late} {time} später an als {early}, das biegt den Kreis um {size} unter ±45°, "
    "mit der Richtung gedreht: Kv, Vorsteuerung und Filter der Antriebe prüfen"};
constexpr Sentence not_square{
    "the axes are not square by {angle} µm/m: align them, or compensate the cross talk",
    "die Achsen stehen um {angle} µm/m nicht rechtwinklig: ausrichten oder den Übersprechfehler "
    "kompensieren"};
constexpr Sentence crossed{
    "a cross term of {angle} µm/m: an active cross compensation, or coupled drives; the measuring systems of "
    "the axes cannot see squareness, a ball bar can (--external)",
    "ein Kreuzterm von {angle} µm/m: eine aktive Kreuzkompensation oder gekoppelte Antriebe; "
    "Rechtwinkligkeit sehen die Messsysteme der Achsen nicht, ein Kreisformmessgerät schon (--external)"};
constexpr Sentence loses{
    "{axis} loses {size} where it reverses: eliminate the play, or set getriebe[].lose (P-AXIS-00103)",
    "{axis} verliert bei der Umkehr {size}: das Spiel beseitigen oder getriebe[].lose (P-AXIS-00103) setzen"};
constexpr Sentence overcompensated{
    "{axis} gains {size} where it reverses: getriebe[].lose (P-AXIS-00103) is too large",
    "{axis} gewinnt bei der Umkehr {size}: getriebe[].lose (P-AXIS-00103) ist zu groß"};
constexpr Sentence sticks{
    "{axis} sticks where it reverses, up to {size}: friction; compensate it, or raise Kv",
    "{axis} haftet bei der Umkehr, bis zu {size}: Reibung; kompensieren oder Kv erhöhen"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

constexpr double us = 1e6;

Quantity um(double value) {
  return rounded(std::abs(value), Unit::micrometre, 3);
}
Quantity time_of(double seconds) {
  return rounded(std::abs(seconds) * us, Unit::microsecond, 3);
}

/// What explains a radius that is too small: the filter that shrinks most.
Words filters_radius(CircleCase const& one, double size) {
  FilterShare const* most = nullptr;
  std::string axis;
  for (std::size_t i = 0; i < one.axes.size(); ++i) {
    for (auto const& share : one.filtered.at(i).shares) {
      if (most != nullptr && share.gain >= most->gain) continue;
      most = &share;
      axis = one.axes.at(i);
    }
  }
  return {says::filters_shrink,
          {{"size", um(size)}, {"filter", most == nullptr ? "-" : most->filter}, {"axis", axis}}};
}

std::vector<NamedValue> delayed(CircleCase const& one, double seconds, double size) {
  bool const is_u = seconds > 0;
  return {{"late", one.axes.at(is_u ? 0 : 1)},
          {"early", one.axes.at(is_u ? 1 : 0)},
          {"time", time_of(seconds)},
          {"size", um(size)}};
}

std::vector<CircleCause> predicted_causes(CircleCase const& one) {
  auto const& circle = one.predicted;
  double const gain = circle.gain_difference();
  double const shrunk = circle.radius_deviation();
  double const bent = circle.radius * std::abs(std::sin(circle.phase));
  return {{says::radius, std::abs(shrunk),
           shrunk < 0 ? std::optional(filters_radius(one, shrunk)) : std::nullopt},
          {Words(says::gain, {{"u", one.axes[0]}, {"v", one.axes[1]}}), std::abs(gain) * circle.radius,
           Words(says::filters_gain, {{"axis", one.axes.at(gain < 0 ? 0 : 1)}})},
          {Words(says::delay, {{"u", one.axes[0]}, {"v", one.axes[1]}}), bent,
           Words(says::filters_delay, delayed(one, one.delay_difference_s(), bent))}};
}

/// What was found is what the lists have.
bool filters_explain(double found, double filters) {
  constexpr double rest = 0.2;
  return std::abs(found - filters) < rest * std::abs(found);
}

Words radius_remedy(CircleCase const& one, double radius) {
  double const filters = one.predicted.radius_deviation();
  if (one.recorded->reference == CircleReference::filtered_setpoint) {
    return {says::radius_after_filters, {{"size", um(radius)}}};
  }
  if (filters < 0 && filters_explain(radius, filters)) return filters_radius(one, filters);
  return {
      says::radius_rest,
      {{"size", rounded(radius, Unit::micrometre, 3)}, {"filters", rounded(filters, Unit::micrometre, 3)}}};
}

Words gain_remedy(CircleCase const& one, double gain) {
  auto const& axis = one.axes.at(gain < 0 ? 0 : 1);
  bool const is_before_filters = one.recorded->reference != CircleReference::filtered_setpoint;
  if (is_before_filters && filters_explain(gain, one.predicted.gain_difference())) {
    return {says::filters_gain, {{"axis", axis}}};
  }
  return {says::gain_recorded, {{"axis", axis}, {"size", um(2 * gain * one.recorded->radius)}}};
}

Words delay_remedy(CircleCase const& one, double seconds, double size) {
  auto values = delayed(one, seconds, size);
  if (one.recorded->reference == CircleReference::filtered_setpoint) {
    return {says::delay_after_filters, std::move(values)};
  }
  double const filters = one.delay_difference_s();
  if (filters_explain(seconds, filters)) return {says::filters_delay, std::move(values)};
  values.push_back({"filters", rounded(filters * us, Unit::microsecond, 3)});
  values.push_back({"axes", one.axes[0] + " - " + one.axes[1]});
  return {says::delay_recorded, std::move(values)};
}

std::vector<CircleCause> recorded_causes(CircleCase const& one) {
  auto const& recorded = *one.recorded;
  if (!recorded.causes) return {};
  auto const& found = *recorded.causes;
  double const radius = recorded.radius;
  double const gain = found.gain_difference;
  double const square = found.squareness;
  double const seconds = found.delay_difference / recorded.angular_speed;
  double const bent = radius * std::abs(std::sin(found.delay_difference));
  Quantity const angle = rounded(square * us, Unit::none, 3);
  std::vector<CircleCause> causes{
      {says::radius, std::abs(found.radius), radius_remedy(one, found.radius)},
      {Words(says::gain, {{"u", one.axes[0]}, {"v", one.axes[1]}}), radius * std::abs(gain),
       gain_remedy(one, gain)},
      {recorded.is_external ? says::squareness : says::cross_term, radius * std::abs(square),
       Words(recorded.is_external ? says::not_square : says::crossed, {{"angle", angle}})},
      {Words(says::delay, {{"u", one.axes[0]}, {"v", one.axes[1]}}), bent, delay_remedy(one, seconds, bent)}};
  for (std::size_t i = 0; i < one.axes.size() && found.is_separable; ++i) {
    auto const& axis = one.axes.at(i);
    double const play = found.backlash.at(i);
    double const spike = found.largest_spike(i);
    causes.push_back(
        {Words(says::backlash, {{"axis", axis}}), std::abs(play),
         Words(play > 0 ? says::loses : says::overcompensated, {{"axis", axis}, {"size", um(play)}})});
    causes.push_back({Words(says::spike, {{"axis", axis}}), spike,
                      Words(says::sticks, {{"axis", axis}, {"size", um(spike)}})});
  }
  return causes;
}

}  // namespace

std::vector<CircleCause> causes_by_size(CircleCase const& one) {
  auto causes = one.recorded ? recorded_causes(one) : predicted_causes(one);
  std::stable_sort(causes.begin(), causes.end(),
                   [](CircleCause const& a, CircleCause const& b) { return a.size_um > b.size_um; });
  return causes;
}

}  // namespace axisc
