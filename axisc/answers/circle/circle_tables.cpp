#include "axisc/answers/circle/circle_tables.hpp"

#include "axisc/answers/labels.hpp"

#include <utility>

namespace axisc::says {

constexpr Sentence figure{"figure", "Kenngröße"};
constexpr Sentence predicted{"predicted", "vorhergesagt"};
constexpr Sentence recorded{"recorded", "aufgezeichnet"};
constexpr Sentence deviation{"circular deviation G, {u} → {v}", "Kreisformabweichung G, {u} → {v}"};
constexpr Sentence bidirectional{"bidirectional G(b)", "in beiden Richtungen G(b)"};
constexpr Sentence mean_radial{"mean radial deviation D", "mittlere Radialabweichung D"};
constexpr Sentence radial_max{"radial deviation F, max", "Radialabweichung F, max"};
constexpr Sentence radial_min{"radial deviation F, min", "Radialabweichung F, min"};
constexpr Sentence hysteresis{"hysteresis", "Umkehrspanne"};
constexpr Sentence cause{"cause", "Ursache"};
constexpr Sentence gain_per_metre{"gain {u} - {v} [µm/m]", "Verstärkung {u} - {v} [µm/m]"};
constexpr Sentence squareness_per_metre{"squareness [µm/m]", "Rechtwinkligkeit [µm/m]"};
constexpr Sentence cross_term_per_metre{"cross term [µm/m]", "Kreuzterm [µm/m]"};
constexpr Sentence reversal_spike{"reversal spike {axis}", "Umkehrspitze {axis}"};
constexpr Sentence unexplained{"unexplained, rms", "nicht erklärt, Effektivwert"};
constexpr Sentence filter{"filter", "Filter"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using circle::Deviations;

namespace {

Value um_cell(std::optional<double> value) {
  return value ? Value(fixed(*value, Unit::micrometre, 2)) : Value();
}

Words of_axes(SentenceRef sentence, CircleCase const& one) {
  return {sentence, {{"u", one.axes[0]}, {"v", one.axes[1]}}};
}

Table for_people(SentenceRef head, bool is_recorded) {
  Table table{.key = {},
              .columns = {head_column({}, head), column({}, says::predicted)},
              .rows = {},
              .audience = Audience::people};
  if (is_recorded) table.columns.push_back(column({}, says::recorded));
  return table;
}

}  // namespace

Table deviations_table(CircleCase const& one) {
  auto table = for_people(says::figure, one.recorded.has_value());
  auto const add = [&](Words name, auto const& figure) {
    table.rows.push_back({std::move(name), um_cell(figure(one.deviations))});
    if (one.recorded) table.rows.back().push_back(um_cell(figure(one.recorded->deviations)));
  };
  add(of_axes(says::deviation, one), [](Deviations const& of) { return of.counterclockwise; });
  add(Words(says::deviation, {{"u", one.axes[1]}, {"v", one.axes[0]}}),
      [](Deviations const& of) { return of.clockwise; });
  add(says::bidirectional, [](Deviations const& of) { return of.bidirectional; });
  add(says::mean_radial, [](Deviations const& of) { return of.mean_radial; });
  add(says::radial_max, [](Deviations const& of) { return of.radial_max; });
  add(says::radial_min, [](Deviations const& of) { return of.radial_min; });
  add(says::hysteresis, [](Deviations const& of) { return of.hysteresis; });
  return table;
}

Table causes_table(CircleCase const& one) {
  auto const* const recorded = one.recorded && one.recorded->causes ? &*one.recorded->causes : nullptr;
  auto table = for_people(says::cause, recorded != nullptr);
  auto const add = [&](Words name, Value predicted, auto const& found) {
    table.rows.push_back({std::move(name), std::move(predicted)});
    if (recorded != nullptr) table.rows.back().push_back(found(*recorded));
  };
  auto const per_million = [](double value) { return Value(fixed(value * millionths, Unit::none, 1)); };
  auto const time = [](double seconds) { return Value(fixed(seconds * millionths, Unit::microsecond, 1)); };
  using circle::Causes;
  add(says::radius, um_cell(one.predicted.radius_deviation()),
      [](Causes const& found) { return um_cell(found.radius); });
  add(of_axes(says::gain_per_metre, one), per_million(one.predicted.gain_difference()),
      [&](Causes const& found) { return per_million(found.gain_difference); });
  add(of_axes(says::delay, one), time(one.delay_difference_s()),
      [&](Causes const& found) { return time(found.delay_difference / one.recorded->angular_speed); });
  if (recorded == nullptr) return table;
  add(one.recorded->is_external ? says::squareness_per_metre : says::cross_term_per_metre, {},
      [&](Causes const& found) { return per_million(found.squareness); });
  for (std::size_t i = 0; i < one.axes.size() && recorded->is_separable; ++i) {
    add(Words(says::backlash, {{"axis", one.axes.at(i)}}), {},
        [i](Causes const& found) { return um_cell(found.backlash.at(i)); });
    add(Words(says::reversal_spike, {{"axis", one.axes.at(i)}}), {},
        [i](Causes const& found) { return um_cell(found.largest_spike(i)); });
  }
  add(says::unexplained, {}, [](Causes const& found) { return um_cell(found.unexplained_rms); });
  return table;
}

Table filters_table(CircleCase const& one) {
  Table table{.key = "filters_um",
              .columns = {head_column("axis", labels::axis), column("filter", says::filter),
                          column("radius_um", says::radius, Unit::micrometre),
                          column("delay_us", labels::delay, Unit::microsecond)},
              .rows = {}};
  for (std::size_t i = 0; i < one.axes.size(); ++i) {
    for (auto const& share : one.filtered.at(i).shares) {
      table.rows.push_back({one.axes.at(i), share.filter,
                            fixed(one.predicted.radius * (share.gain - 1), Unit::micrometre, 3),
                            fixed(share.delay_s * millionths, Unit::microsecond, 1)});
    }
  }
  return table;
}

}  // namespace axisc
