#include "axisc/answers/explain/parameter_facts.hpp"

#include "design/filter_kinds.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/value.hpp"
#include "validator/engine/rule.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace axisc::says {

constexpr Sentence explain_manual_filter{"Axis filters, section 3.2", "Achsfilter, Abschnitt 3.2"};
constexpr Sentence explain_manual_interface{"Axis filters, section 3.3", "Achsfilter, Abschnitt 3.3"};
constexpr Sentence explain_manual_fir{"FIR filters, section 6.2", "FIR-Filter, Abschnitt 6.2"};
constexpr Sentence explain_manual_position_control{"Improved Position Control, section 4.2",
                                                   "Optimierte Lageregelung, Abschnitt 4.2"};
constexpr Sentence value{"value", "Wert"};
constexpr Sentence nyquist{"0.5/T (500 Hz at T = 1 ms)", "0,5/T (500 Hz bei T = 1 ms)"};
constexpr Sentence used{"used", "wird verwendet"};
constexpr Sentence order_of_type{"the type gives the order; 0 switches the filter off",
                                 "der Typ gibt die Ordnung vor; 0 schaltet den Filter ab"};
constexpr Sentence hsc_order{"HSC: 0 ≤ value ≤ 200 cycles; with 0 `time_constant` counts",
                             "HSC: 0 ≤ Wert ≤ 200 Zyklen; bei 0 zählt `time_constant`"};
constexpr Sentence hsc_time{"HSC with order 0: T < value < 200 T", "HSC mit Ordnung 0: T < Wert < 200 T"};
constexpr Sentence hsc_frequency{"HSC NoVib: 0 < value < 0.5/T", "HSC-NoVib: 0 < Wert < 0,5/T"};
constexpr Sentence fir_order{"0 ≤ value ≤ 200, with type 4 (time delay) ≤ 100",
                             "0 ≤ Wert ≤ 200, bei Typ 4 (Zeitverzögerung) ≤ 100"};
constexpr Sentence fir_order_time{"T ≤ value ≤ 200 T, with type 4 (time delay) ≤ 100 T",
                                  "T ≤ Wert ≤ 200 T, bei Typ 4 (Zeitverzögerung) ≤ 100 T"};
constexpr Sentence fir_frequency{"type 3 (windowed sinc): 0 < value < 0.5/T (500 Hz at T = 1 ms)",
                                 "Typ 3 (Windowed-Sinc): 0 < Wert < 0,5/T (500 Hz bei T = 1 ms)"};
constexpr Sentence stage_frequency{"0 < value < 0.5/T (500 Hz at T = 1 ms)",
                                   "0 < Wert < 0,5/T (500 Hz bei T = 1 ms)"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// Parameters by the beginning of their names; the first that fits counts.
constexpr std::array<std::pair<std::string_view, SentenceRef>, 7> manuals = {{
    {"filter_fir.", says::explain_manual_fir},
    {"filter[", says::explain_manual_filter},
    {"lr_param.add_interface.", says::explain_manual_interface},
    {"lr_param.improved_position_control.", says::explain_manual_position_control},
    {"antr.v_reso_", says::explain_manual_position_control},
    {"antr.v_time_base", says::explain_manual_position_control},
    {"getriebe[].multi_gain_", says::explain_manual_position_control},
}};

/// Ranges that are not in the catalogue, because they depend on T.
constexpr std::array<std::pair<std::string_view, SentenceRef>, 8> further_ranges = {{
    {"filter[].order", says::hsc_order},
    {"filter[].time_constant", says::hsc_time},
    {"filter[].fg_f0", says::hsc_frequency},
    {"filter_fir.order", says::fir_order},
    {"filter_fir.order_time", says::fir_order_time},
    {"filter_fir.fcut", says::fir_frequency},
    {"lr_param.improved_position_control.stage[].filter.fg_f0", says::stage_frequency},
    {"lr_param.improved_position_control.stage[].filter[].fg_f0", says::stage_frequency},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unit_words = {
    {{"cycle", "Zyklen"}, {"increment", "Inkremente"}, {"rev", "Umdrehung"}}};

/// The parameter's name in a filter of one of the ports: "order"; empty for other parameters.
std::string_view name_in_filter(std::string_view name) {
  for (std::string_view const port : {"filter[].", "lr_param.add_interface.filter[]."}) {
    if (name.starts_with(port)) return name.substr(port.size());
  }
  return {};
}

/// What a filter of the type allows; empty where it does not use the parameter.
std::string range_of(design::FilterKind const& kind, std::string_view name, Language language) {
  auto const say = [&](SentenceRef text, std::vector<Argument> arguments = {}) {
    return render({.sentence = text, .arguments = std::move(arguments)}, language);
  };
  auto const value = say(says::value);
  auto const exact = [&](double number) { return exact_number(number).in(language); };
  if (name == "fg_f0" && kind.uses_frequency) return "0 < " + value + " < " + say(says::nyquist);
  if (name == "prototype" && kind.uses_prototype) return say(says::used);
  if (name == "guete" && kind.quality) {
    return exact(kind.quality->lowest) + " ≤ " + value + " ≤ " + exact(kind.quality->highest);
  }
  if (name == "order") {
    if (kind.order.source != design::OrderSource::configured) return say(says::order_of_type);
    return "1 ≤ " + value + " ≤ " + std::to_string(kind.order.highest);
  }
  if (name == "time_constant" && kind.time_constant) {
    auto const& range = *kind.time_constant;
    auto const lowest = range.lowest == 0 ? "0" : range.lowest == 1 ? "T" : exact(range.lowest) + " T";
    return lowest + " ≤ " + value + (std::isinf(range.limit) ? "" : " < " + exact(range.limit) + " T");
  }
  return {};
}

}  // namespace

std::vector<std::string> rules_about(schema::Parameter const& parameter) {
  std::vector<std::string> codes;
  if (parameter.kind != schema::ListKind::axis) return codes;
  for (auto const& rule : validator::rules()) {
    if (validator::looks_at(rule, parameter)) codes.push_back(code_text(rule.code));
  }
  return codes;
}

std::vector<std::string> ranges_by_type(schema::Parameter const& parameter, Language language) {
  std::vector<std::pair<std::string, std::string>> types_of_range;
  if (parameter.kind != schema::ListKind::axis) return {};
  auto const name = name_in_filter(parameter.name);
  for (auto const& kind : design::filter_kinds) {
    auto const range = range_of(kind, name, language);
    if (range.empty()) continue;
    auto const known = std::find_if(types_of_range.begin(), types_of_range.end(),
                                    [&](auto const& row) { return row.first == range; });
    auto const word = "`" + std::string(kind.word) + "`";
    if (known == types_of_range.end()) {
      types_of_range.emplace_back(range, word);
    } else {
      known->second += ", " + word;
    }
  }
  std::vector<std::string> lines;
  lines.reserve(types_of_range.size());
  for (auto& [range, types] : types_of_range) lines.push_back(types.append(": ").append(range));
  for (auto const& [pattern, text] : further_ranges) {
    if (parameter.name == pattern) lines.push_back(render({.sentence = text, .arguments = {}}, language));
  }
  return lines;
}

std::string unit_name(std::string_view unit, Language language) {
  auto text = validator::raw_unit_name(unit);
  for (auto const& [power, digits] :
       {std::pair("1e-4 ", "0.0001 "), {"1e-3 ", "0.001 "}, {"1e3 ", "1000 "}}) {
    if (text.starts_with(power)) text.replace(0, std::string_view(power).size(), digits);
  }
  if (language == Language::english) return text;
  text = Wording::number(text).in(language);
  for (auto const& [word, german] : unit_words) {
    if (auto const at = text.find(word); at != std::string::npos) text.replace(at, word.size(), german);
  }
  return text;
}

std::string manual_section(schema::Parameter const& parameter, Language language) {
  for (auto const& [beginning, text] : manuals) {
    if (parameter.kind == schema::ListKind::axis && parameter.name.substr(0, beginning.size()) == beginning) {
      return render({.sentence = text, .arguments = {}}, language);
    }
  }
  return {};
}

}  // namespace axisc
