#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "image/chain_figures.hpp"

#include <cmath>
#include <numbers>

namespace axisc::says {

constexpr Sentence setpoint{"setpoint", "Sollwert"};
constexpr Sentence interface { "interface", "Schnittstelle" };
constexpr Sentence prototype{"prototype", "Prototyp"};
constexpr Sentence time_constant{"time constant", "Zeitkonstante"};
constexpr Sentence realisation{"realised as", "realisiert als"};
constexpr Sentence pass_through{"passes unchanged", "unverändert"};
constexpr Sentence in_sections{"sections", "Abschnitte"};
constexpr Sentence pure_delay{"pure delay", "reine Verzögerung"};
constexpr Sentence dc_gain{"gain at 0 Hz", "Verstärkung bei 0 Hz"};
constexpr Sentence at_most{"at most {gain}", "höchstens {gain}"};
constexpr Sentence pole_radius{"largest pole radius", "größter Polradius"};
constexpr Sentence section{"section", "Abschnitt"};
constexpr Sentence pole_radii{"pole radii", "Polradien"};
constexpr Sentence pole_frequencies{"pole frequencies", "Polfrequenzen"};
constexpr Sentence control{"Improved Position Control", "Optimierte Lageregelung"};
constexpr Sentence additive{"additive velocity", "additive Geschwindigkeit"};
constexpr Sentence limited{"within ±{limit}", "innerhalb ±{limit}"};
constexpr Sentence of_master{"that of the gantry master {axis}", "die des Gantry-Masters {axis}"};
constexpr Sentence position{"position control", "Lageregelung"};
constexpr Sentence in_drive{"in the drive", "im Antrieb"};
constexpr Sentence in_cnc{"in the CNC", "in der CNC"};
constexpr Sentence unknown{"it is not known where: no increments", "wo, ist nicht bekannt: keine Inkremente"};
constexpr Sentence increments{"increments per µm/s", "Inkremente je µm/s"};
constexpr Sentence rotary_increments{"increments per 0.001 °/s", "Inkremente je 0,001 °/s"};
constexpr Sentence stage{
    "stage[{index}] {mode}, weight {weight} ({numerator}/{denominator}), subtracted",
    "stage[{index}] {mode}, Gewicht {weight} ({numerator}/{denominator}), wird abgezogen"};
constexpr Sentence oscillator{"oscillator", "Schwinger"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Quantity radius_value(double radius) {
  return {.value = radius, .digits = Digits::significant(9)};
}

/// With its poles, of which people see radius and frequency beside the coefficients.
void add_section(Table& table, design::IncrementSection const& section, bool blocks_constant,
                 design::CycleTime cycle_time) {
  auto const direct = design::direct_form(section, blocks_constant);
  auto const [first, second] = design::poles(section);
  Numbers radii{.values = {}, .digits = Digits::significant(9)};
  Numbers frequencies{.values = {}, .unit = Unit::hertz, .digits = Digits::significant(5)};
  Table poles{.key = "poles", .audience = Audience::programs};
  for (auto const& pole : {first, second}) {
    double const frequency = std::abs(std::arg(pole)) / (2 * std::numbers::pi * cycle_time.seconds());
    radii.values.push_back(std::abs(pole));
    frequencies.values.push_back(frequency);
    add_row(poles, {data("real", exact(pole.real())), data("imaginary", exact(pole.imag())),
                    data("radius", exact(std::abs(pole))), data("frequency_hz", exact(frequency))});
  }
  std::vector<Field> row{shown(says::section, table.rows.size() + 1)};
  using Letter = std::pair<char const*, double>;
  for (auto const& [letter, coefficient] :
       {Letter("b0", direct.b0), Letter("b1", direct.b1), Letter("b2", direct.b2), Letter("a1", direct.a1),
        Letter("a2", direct.a2), Letter("p", section.p), Letter("q", section.q), Letter("k", section.k),
        Letter("b", section.b)}) {
    row.push_back({letter, as_given(letter), exact(coefficient)});
  }
  row.push_back(shown(says::pole_radii, std::move(radii)));
  row.push_back(shown(says::pole_frequencies, std::move(frequencies)));
  add_row(table, std::move(row));
  table.details.push_back({.key = {}, .title = {}, .blocks = {std::move(poles)}});
}

Table sections_table(design::FilterDesign const& made, design::CycleTime cycle_time) {
  Table table{.key = "sections"};
  for (auto const& section : made.sections) add_section(table, section, made.blocks_constant, cycle_time);
  return table;
}

Symbol realisation_symbol(design::Realisation realisation) {
  switch (realisation) {
    case design::Realisation::pass_through: return {"pass-through", says::pass_through};
    case design::Realisation::delay: return {"delay", says::pure_delay};
    case design::Realisation::sections: break;
  }
  return {"sections", says::in_sections};
}

Symbol controller_symbol(machine::PositionController controller) {
  switch (controller) {
    case machine::PositionController::drive: return {"drive", says::in_drive};
    case machine::PositionController::cnc: return {"cnc", says::in_cnc};
    case machine::PositionController::unknown: break;
  }
  return {"unknown", says::unknown};
}

Section stage_section(image::ImageStage const& stage, design::CycleTime cycle_time) {
  Table filters{.key = "filters"};
  for (auto const& filter : stage.filters) {
    auto const& wanted = filter.specification;
    auto const& made = filter.design;
    bool const swings = stage.has_oscillator && filters.rows.empty();
    Value const type = swings ? Value(Symbol{"oscillator", says::oscillator}) : type_word(wanted.type);
    bool const has_quality = !swings && design::uses_quality(wanted.type);
    add_row(filters, {{"type", labels::type, type},
                      {"prototype", says::prototype, value_if(!swings, prototype_word(wanted.prototype))},
                      {"order", labels::order, value_if(!swings, wanted.order)},
                      {"frequency_hz", labels::frequency, exact(wanted.frequency.value, Unit::hertz)},
                      {"quality", labels::quality, value_if(has_quality, exact(wanted.quality))},
                      {"damping", labels::damping, value_if(swings, exact(wanted.quality))},
                      {"pole_radius", says::pole_radius, radius_value(made.pole_radius)},
                      {"dc_gain", says::dc_gain, rounded(made.dc_gain)},
                      {"self_test_samples", labels::self_test, filter.self_test_input.size()}});
    filters.details.push_back(part(as_given(type), {sections_table(made, cycle_time)}));
  }
  std::string_view const mode = mode_word(stage.mode);
  auto const [weight, numerator, denominator] =
      std::tuple(exact(stage.weight), exact(stage.weight_numerator), exact(stage.weight_denominator));
  return {.key = {},
          .title = Words(says::stage, {{"index", stage.index},
                                       {"mode", mode},
                                       {"weight", weight},
                                       {"numerator", numerator},
                                       {"denominator", denominator}}),
          .blocks = {std::move(filters)},
          .identity = {data("index", stage.index), data("mode", mode), data("weight", weight),
                       data("weight_numerator", numerator), data("weight_denominator", denominator)}};
}

}  // namespace

Value peak_gain_value(double peak_gain, bool is_reached) {
  if (is_reached) return rounded(peak_gain);
  return Words(says::at_most, {{"gain", rounded(peak_gain)}});
}

Table values_table(std::string key, std::span<image::ImageValue const> values, Audience audience) {
  Table table{.key = std::move(key), .audience = audience};
  for (auto const& [name, value, list, line] : values) {
    add_row(table, {{"name", labels::parameter, name},
                    {"value", labels::value, value},
                    data("file", list),
                    data("line", line),
                    shown(labels::from, list + ":" + std::to_string(line))});
  }
  return table;
}

Table filters_table(image::ImageAxis const& axis, bool interface, design::CycleTime cycle_time) {
  Table table{.key = interface ? "interface_filters" : "filters"};
  for (auto const& filter : interface ? axis.interface_filters : axis.filters) {
    auto const& wanted = filter.specification;
    auto const& made = filter.design;
    auto const path = filter_path(filter, interface);
    auto const gain_is_reached = image::reaches_peak_gain(filter);
    add_row(table,
            {data("path", path),
             data("index", filter.index),
             shown(interface ? says::interface : says::setpoint, path.substr(path.rfind('.') + 1)),
             {"type", labels::type, type_word(wanted.type)},
             {"prototype", says::prototype,
              value_if(design::uses_prototype(wanted.type), prototype_word(wanted.prototype))},
             {"order", labels::order, value_if(!design::computes_order(wanted.type), wanted.order)},
             {"frequency_hz", labels::frequency,
              value_if(design::uses_frequency(wanted.type), exact(wanted.frequency.value, Unit::hertz))},
             {"quality", labels::quality, value_if(design::uses_quality(wanted.type), exact(wanted.quality))},
             {"time_constant_us", says::time_constant,
              value_if(design::uses_time_constant(wanted.type),
                       exact(wanted.time_constant.value, Unit::microsecond))},
             {"share_percent", labels::share, exact(wanted.share_percent, Unit::percent)},
             data("reading", reading_value(wanted.reading)),
             data("computed_for", reading_value(wanted.cycle_time)),
             {"realisation", says::realisation, realisation_symbol(made.realisation)},
             data("pure_delay_cycles",
                  value_if(made.realisation == design::Realisation::delay, made.delay_cycles)),
             {"group_delay_cycles", labels::delay, rounded(made.group_delay_cycles, Unit::cycle)},
             {"group_delay_ms", labels::delay,
              rounded(made.group_delay_cycles * cycle_time.seconds() * 1e3, Unit::millisecond)},
             {"dc_gain", says::dc_gain, rounded(made.dc_gain)},
             {"overshoot_percent", labels::overshoot, rounded(filter.overshoot * 100, Unit::percent)},
             data("peak_gain", exact(filter.peak_gain)),
             data("peak_gain_is_reached", gain_is_reached),
             shown(labels::peak_gain, peak_gain_value(filter.peak_gain, gain_is_reached)),
             {"pole_radius", says::pole_radius, radius_value(made.pole_radius)},
             data("kernel_sum", exact(filter.kernel_sum)),
             {"self_test_samples", labels::self_test, filter.self_test_input.size()}});
    table.details.push_back(part(
        as_given(path), {sections_table(made, cycle_time),
                         values_table("settings", settings_of(axis, filter, interface), Audience::all)}));
  }
  return table;
}

Section control_section(image::ImageContents const& image, std::size_t axis) {
  auto const& control = *image.axes[axis].control;
  auto const& scaling = control.scaling;
  bool const linear = image.axes[axis].type == 1;
  auto const source = axis_label(image, control.source);
  auto const limit =
      rounded(control.limit / 1e3, linear ? Unit::millimetre_per_second : Unit::degree_per_second);
  Sections stages{.key = "stages", .items = {}};
  for (auto const& stage : control.stages) stages.items.push_back(stage_section(stage, image.cycle_time));
  return {.key = "position_control",
          .title = says::control,
          .blocks = {Facts{{data("source", source),
                            data("limit", exact(control.limit)),
                            data("limit_factor", exact(control.limit_factor)),
                            shown(says::additive, control.source == axis
                                                      ? Words(says::limited, {{"limit", limit}})
                                                      : Words(says::of_master, {{"axis", source}})),
                            {"position_control", says::position, controller_symbol(scaling.controller)},
                            data("time_base", scaling.time_base),
                            data("v_reso_num", exact(scaling.v_reso_num)),
                            data("v_reso_denom", exact(scaling.v_reso_denom)),
                            data("multi_gain_z", exact(scaling.multi_gain_z)),
                            data("multi_gain_n", exact(scaling.multi_gain_n)),
                            {"increments_per_velocity", linear ? says::increments : says::rotary_increments,
                             exact(control.increments_per_velocity)}}},
                     std::move(stages)}};
}

}  // namespace axisc
