#include "axisc/answers/identify/identify_answer.hpp"

#include "analysis/tuning/rigid_model/thresholds.hpp"
#include "axisc/answers/execution/mapping_table.hpp"
#include "axisc/answers/labels.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence title{"axis {axis}: mass and friction from its motion",
                         "Achse {axis}: Masse und Reibung aus ihrer Bewegung"};
constexpr Sentence quantity{"quantity", "Größe"};
constexpr Sentence uncertainty{"±", "±"};
constexpr Sentence unit{"unit", "Einheit"};
constexpr Sentence because{"why not", "warum nicht"};
constexpr Sentence mass{"mass, motor and load", "Masse, Motor und Last"};
constexpr Sentence inertia{"inertia, motor and load", "Trägheitsmoment, Motor und Last"};
constexpr Sentence coulomb{"Coulomb friction", "Coulombsche Reibung"};
constexpr Sentence viscous{"viscous friction", "viskose Reibung"};
constexpr Sentence constant{"constant force (gravity)", "konstante Kraft (Gewicht)"};
constexpr Sentence nothing_seen{"none is seen", "keine zu sehen"};
constexpr Sentence too_uncertain{"uncertain by {share} %, {most} % are allowed",
                                 "um {share} % unsicher, erlaubt sind {most} %"};
constexpr Sentence windows{
    "{windows} windows of {length} in which the axis moves one way; {accelerating} of the varying force "
    "accelerates, and what every other window shows explains {explained} of the force between them",
    "{windows} Fenster von {length}, in denen die Achse in einer Richtung fährt; {accelerating} der "
    "veränderlichen Kraft beschleunigen, und was jedes zweite Fenster zeigt, erklärt {explained} der Kraft "
    "dazwischen"};
constexpr Sentence dead_time{"the force comes {time} after the motion in the recording",
                             "die Kraft kommt in der Aufzeichnung {time} nach der Bewegung"};
constexpr Sentence guessed_unit{
    "nothing names the unit of the position: whole numbers count as 0.1 µm or 0.0001°, others as mm or "
    "degrees; --unit says it",
    "nichts nennt die Einheit der Position: ganze Zahlen gelten als 0,1 µm oder 0,0001°, andere als mm oder "
    "Grad; --unit gibt sie an"};
constexpr Sentence unknown_force{"F is the force as it was recorded: nothing names its unit",
                                 "F ist die Kraft, wie sie aufgezeichnet ist: Nichts nennt ihre Einheit"};
constexpr Sentence at_the_motor{
    "\"{unit}\": the force is not one that acts along the axis; the mass in kg takes the transmission",
    "„{unit}“: Die Kraft ist keine, die entlang der Achse wirkt; für die Masse in kg braucht es die "
    "Übersetzung"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;
using tuning::Estimate;

constexpr double percent_per_one = 100;

Value why_not(Estimate const& estimate, double largest) {
  if (!(estimate.value > 0)) return Words(says::nothing_seen);
  return Words(says::too_uncertain,
               {{"share", rounded(percent_per_one * estimate.uncertainty / estimate.value, Unit::none, 2)},
                {"most", rounded(percent_per_one * largest, Unit::none, 2)}});
}

/// So that an uncertainty has two digits.
int decimals_of(double uncertainty) {
  constexpr int most = 12;
  if (!(uncertainty > 0)) return 0;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty))), 0, most);
}

struct EstimateRow {
  std::string_view symbol;
  SentenceRef label;
  Estimate estimate;
  std::string unit;
  bool is_given = true;
  Value because = {};
};

Table estimates_table(IdentifiedAxis const& found) {
  auto const& model = found.model;
  auto const units = model_units(found.force, found.is_rotary, "F");
  EstimateRow const rows[] = {
      {"mass", found.is_rotary ? SentenceRef(says::inertia) : SentenceRef(says::mass), model.mass,
       units.mass},
      {"coulomb_friction", says::coulomb, model.coulomb, units.force, model.has_coulomb(),
       why_not(model.coulomb, tuning::largest_coulomb_uncertainty)},
      {"viscous_friction", says::viscous, model.viscous, units.viscous, model.has_viscous(),
       why_not(model.viscous, tuning::largest_viscous_uncertainty)},
      {"constant_force", says::constant, model.constant, units.force}};
  bool const gives_all = model.has_coulomb() && model.has_viscous();
  Table table{.key = "estimates"};
  for (auto const& row : rows) {
    auto const number = [&](double value) {
      return row.is_given ? Value(fixed(value, Unit::none, decimals_of(row.estimate.uncertainty)))
                          : Value(Nothing{});
    };
    std::vector<Field> fields{{"quantity", says::quantity, Symbol{.symbol = row.symbol, .words = row.label}},
                              {"value", labels::value, number(row.estimate.value)},
                              {"uncertainty", says::uncertainty, number(row.estimate.uncertainty)},
                              {"unit", says::unit, row.unit},
                              data("given", row.is_given)};
    if (!gives_all) fields.push_back(shown(says::because, row.is_given ? Value() : row.because));
    add_row(table, std::move(fields));
  }
  return table;
}

}  // namespace

Document identify_answer(IdentifiedAxis const& found) {
  auto const& model = found.model;
  double const length_ms = static_cast<double>(model.length) * found.sample_time_ms;
  double const dead_time_ms = model.dead_time * found.sample_time_ms;
  auto const milliseconds = [](double value) { return rounded(value, Unit::millisecond, 4); };
  auto const share = [](double value) { return rounded(percent_per_one * value, Unit::percent, 3); };
  std::vector<std::string> signals;
  std::vector<MappedColumn> columns;
  for (auto const& used : found.mapping) {
    signals.push_back(used.signal);
    columns.push_back(used.column);
  }
  std::vector<Block> blocks{Facts{{data("axis", found.axis)}}, estimates_table(found),
                            mapping_table(signals, columns)};
  blocks.emplace_back(
      Facts{{data("windows", model.windows), data("window_ms", length_ms),
             data("accelerating_percent", percent_per_one * model.accelerating),
             data("explained_percent", percent_per_one * model.explained), data("dead_time_ms", dead_time_ms),
             data("position_unit_guessed", found.is_unit_guessed)}});
  blocks.emplace_back(Paragraph{Words(says::windows, {{"windows", model.windows},
                                                      {"length", milliseconds(length_ms)},
                                                      {"accelerating", share(model.accelerating)},
                                                      {"explained", share(model.explained)}})});
  if (model.dead_time != 0) {
    blocks.emplace_back(Paragraph{Words(says::dead_time, {{"time", milliseconds(dead_time_ms)}})});
  }
  if (found.is_unit_guessed) blocks.emplace_back(Paragraph{says::guessed_unit});
  if (found.force.symbol.empty()) {
    blocks.emplace_back(Paragraph{says::unknown_force});
  } else if (!found.is_rotary && found.force.kind != ForceKind::newton) {
    auto const units = model_units(found.force, found.is_rotary, "F");
    blocks.emplace_back(Paragraph{Words(says::at_the_motor, {{"unit", units.mass}})});
  }
  return {.version = 1,
          .title = Words(says::title, {{"axis", found.axis}}),
          .blocks = std::move(blocks),
          .csv_table = "estimates"};
}

}  // namespace axisc
