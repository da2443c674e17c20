#include "editor/capabilities/hints.hpp"

#include "design/filter_kinds.hpp"
#include "design/kernels/vibration_guard.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/meaning/delay_notes.hpp"
#include "editor/meaning/dynamics_notes.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "editor/reading/requests.hpp"
#include "schema/value.hpp"
#include "validator/views/filter_view.hpp"
#include "validator/views/guard_view.hpp"
#include "validator/views/units_text.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence half_period{"half a period: {time} ms", "halbe Periode: {time} ms"};
constexpr Sentence defaults{"{values} by default", "{values} (Standard)"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// "= 42.5 Hz"; empty if the unit is unknown.
std::string quantity(OpenList const& list, schema::NameLookup const& found, grammar::Assignment const& line,
                     Language language) {
  if (found.row == nullptr || !found.row->symbols.empty()) return {};
  auto const number = schema::read_real(list.slice(line.value));
  if (number.status != schema::NumberStatus::good) return {};
  auto const unit = list.unit_of(*found.row);
  return unit.empty() || list.is_unit_open(*found.row)
             ? ""
             : "= " + validator::physical(number.number, unit).in(language);
}

/// "= 50 ms, 40 m/s³"
std::string with_note(std::string quantity, std::string const& note) {
  if (note.empty()) return quantity;
  return quantity.empty() ? note : std::move(quantity) + ", " + note;
}

/// How far the impulses of the guard are apart, behind its frequency.
std::string half_period_of(OpenList const& list, Language language) {
  auto const guard = validator::GuardView(list.axis()->merged.values).specification(list.cycle_time());
  if (!guard) return {};
  double const milliseconds = design::guard_impulses(*guard)[1].time.value / 1000;
  return say(says::half_period, language, {{"time", format_rounded(milliseconds, 3)}});
}

/// Values that the filter's type uses and no list sets: "order 2, guete 1".
std::string defaults_of(validator::FilterView const& filter) {
  std::string text;
  auto const add = [&text](validator::EffectiveValue const& value, bool is_used) {
    if (!is_used || value.set() || !value.row->has_default) return;
    auto const name = std::string_view(value.row->name);
    text += (text.empty() ? "" : ", ") + std::string(name.substr(name.rfind('.') + 1)) + " " +
            validator::default_text(*value.row);
  };
  if (!filter.standard_type) return text;
  auto const type = *filter.standard_type;
  add(filter.order, design::uses_prototype(type));
  add(filter.prototype, design::uses_prototype(type));
  add(filter.quality, design::uses_quality(type));
  add(filter.share, true);
  add(filter.time_constant, design::uses_time_constant(type));
  return text;
}

}  // namespace

Json hints(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto found = Json::array();
  if (!is_list(asked.path)) return found;
  auto const first = position_in(params.at("range").at("start"));
  auto const last = position_in(params.at("range").at("end"));
  auto const& list = machines.list_of(asked);
  TextLines const lines(asked.text, machines.encoding());
  auto const add = [&](std::size_t offset, std::string label) {
    auto const at = lines.position(offset);
    if (label.empty() || at < first || last < at) return;
    found.push_back({{"position", position_json(at)}, {"label", std::move(label)}, {"paddingLeft", true}});
  };
  DynamicsNotes notes(list, machines.language());
  for (auto const& line : list.tree().assignments) {
    auto const found_name = list.find(list.slice(line.name));
    bool const is_guard =
        found_name.row != nullptr && found_name.row->name == "vib_guard.freq" && list.axis() != nullptr;
    auto note = is_guard ? half_period_of(list, machines.language()) : notes.of(line, found_name);
    if (note.empty()) note = delay_in_cycles(list, found_name, line, machines.language());
    add(line.value.end, with_note(quantity(list, found_name, line, machines.language()), note));
  }
  if (list.axis() == nullptr) return found;
  auto const& values = list.axis()->merged.values;
  for (auto const& filter : validator::touched_filters(values)) {
    auto const defaults = defaults_of(filter);
    auto const place = filter.type.value_place();
    if (defaults.empty() || !place || list.sources()[place->source].name() != list.text().name()) continue;
    add(place->span.end, machines.say(says::defaults, {{"values", defaults}}));
  }
  return found;
}

}  // namespace axisc::editor
