#include "axisc/answers/values/values_answer.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/answers/values/chosen_values.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/location.hpp"
#include "schema/data_type.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/check.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace axisc::says {

constexpr Sentence values_of{"Axis {axis}: values in force", "Achse {axis}: wirksame Werte"};
constexpr Sentence origin{"from", "aus"};
constexpr Sentence at_line{"{file}:{line}", "{file}:{line}"};
constexpr Sentence at_default_line{"{file}:{line} (default list)", "{file}:{line} (Standardliste)"};
constexpr Sentence from_default{"default", "Standardwert"};
constexpr Sentence from_nothing{"not set; no default is documented",
                                "nicht gesetzt; kein Standardwert ist dokumentiert"};
constexpr Sentence equals{"{value} = {physical}", "{value} = {physical}"};
constexpr Sentence meaning{"{value} [{meaning}]", "{value} [{meaning}]"};
constexpr Sentence value_unit{"{value} {unit}", "{value} {unit}"};
constexpr Sentence replaced{"the control uses {value} ({code})", "die Steuerung verwendet {value} ({code})"};
constexpr Sentence unusable{"cannot be used ({code})", "nicht verwendbar ({code})"};
constexpr Sentence unusable_line{"the line is not usable; `axisc lint` says why",
                                 "die Zeile ist nicht verwendbar; `axisc lint` sagt, warum"};
constexpr Sentence control_uses{"correction", "Korrektur"};
constexpr Sentence name_parameters{"name a parameter, or --all", "einen Parameter nennen, oder --all"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::EffectiveValue;
using validator::Origin;

namespace {

/// By the parameter's name: the finding that says what the control makes of its value, or else the first
/// error.
using Corrections = std::map<std::string, Finding>;

class AxisValues {
 public:
  AxisValues(validator::LoadedAxis const& axis, SourceSet const& sources, Corrections corrections)
      : axis_(axis), sources_(sources), corrections_(std::move(corrections)) {}

  [[nodiscard]] Table table(std::vector<schema::Slot> const& slots) const {
    bool const has_corrections = std::any_of(slots.begin(), slots.end(), [&](schema::Slot slot) {
      return correction_of(value_of(slot)) != nullptr || value_of(slot).unusable;
    });
    Table table{.key = "values"};
    for (auto const slot : slots) {
      auto fields = fields_of(value_of(slot));
      if (has_corrections) fields.push_back(shown(says::control_uses, correction_words(value_of(slot))));
      add_row(table, std::move(fields));
    }
    return table;
  }

 private:
  [[nodiscard]] EffectiveValue const& value_of(schema::Slot slot) const { return axis_.merged.values[slot]; }

  [[nodiscard]] std::string_view unit_of(EffectiveValue const& value) const {
    return validator::unit_of(*value.row, axis_.type);
  }

  /// As the list writes it, or as the default is documented.
  [[nodiscard]] std::string written(EffectiveValue const& value) const {
    if (value.set()) return value.has_value ? sources_[value.source].utf8(value.value_span) : std::string();
    return validator::default_text(*value.row);
  }

  [[nodiscard]] static bool has_number(EffectiveValue const& value) {
    return value.row->type != schema::DataType::string || value.row->is_enumeration();
  }

  /// The number or the word that counts; of a reference what it leads to.
  [[nodiscard]] static std::string in_force(EffectiveValue const& value) {
    if (!value.set() && !value.row->has_default && !value.referenced) return {};
    bool const is_flag = value.row->type == schema::DataType::boolean;
    bool const is_word = !is_flag && (!value.value.text.empty() || !has_number(value));
    return is_word ? std::string(value.value.text) : format_exact(value.value.number);
  }

  [[nodiscard]] static Wording meaning_of(EffectiveValue const& value) {
    auto const number = format_exact(value.value.number);
    for (auto const& described : schema::description_of(*value.row).values) {
      bool const is_meant =
          value.value.text.empty() ? described.value == number : described.value == value.value.text;
      if (is_meant) return Wording(described.meaning);
    }
    for (auto const& named : value.row->number_names) {
      if (named.number == value.value.number) return validator::number_name(*value.row, named);
    }
    return {};
  }

  [[nodiscard]] Value shown_value(EffectiveValue const& value) const {
    auto const text = in_force(value);
    if (text.empty()) return {};
    Value told = text;
    auto const as_written = written(value);
    if (value.referenced && !as_written.empty()) {
      told = Words(says::equals, {{"value", as_written}, {"physical", told}});
    }
    auto const unit = unit_of(value);
    bool const is_number = value.value.text.empty() && has_number(value);
    if (is_number && validator::is_scaled(unit)) {
      return Words(says::equals,
                   {{"value", told}, {"physical", validator::physical(value.value.number, unit)}});
    }
    if (is_number && !unit.empty()) {
      return Words(says::value_unit, {{"value", told}, {"unit", validator::unit_name(unit)}});
    }
    auto const meaning = meaning_of(value);
    return meaning.empty() ? told : Value(Words(says::meaning, {{"value", told}, {"meaning", meaning}}));
  }

  [[nodiscard]] Value origin_of(EffectiveValue const& value) const {
    if (auto const place = value.name_place()) {
      auto const file = std::string(validator::file_name(locate(*place, sources_).file));
      bool const is_default_list = value.origin == Origin::default_list;
      auto const words = Words(is_default_list ? says::at_default_line : says::at_line,
                               {{"file", file}, {"line", std::to_string(value.line)}});
      return Symbol{is_default_list ? "default_list" : "axis_list", words};
    }
    bool const is_known = value.row->has_default || value.referenced;
    return is_known ? Symbol{"default", says::from_default} : Symbol{"none", says::from_nothing};
  }

  [[nodiscard]] Finding const* correction_of(EffectiveValue const& value) const {
    auto const found = corrections_.find(parameter_name(value));
    return found == corrections_.end() ? nullptr : &found->second;
  }

  [[nodiscard]] Value correction_words(EffectiveValue const& value) const {
    auto const* const finding = correction_of(value);
    if (finding == nullptr) return value.unusable ? Value(Words(says::unusable_line)) : Value();
    auto const code = code_text(finding->code);
    bool const is_replaced = finding->control && !finding->control->value.empty();
    return is_replaced ? Words(says::replaced, {{"value", finding->control->value}, {"code", code}})
                       : Words(says::unusable, {{"code", code}});
  }

  [[nodiscard]] std::vector<Field> fields_of(EffectiveValue const& value) const {
    auto const* const finding = correction_of(value);
    auto const text = in_force(value);
    auto const unit = unit_of(value);
    auto const place = value.name_place();
    bool const is_number = !text.empty() && has_number(value);
    auto const number = schema::number_text(value.row->kind, value.row->p_axis);
    auto const text_or_nothing = [](auto const& written) {
      return written.empty() ? Value() : Value(written);
    };
    auto const& control = finding != nullptr ? finding->control : std::nullopt;
    return {{"parameter", labels::parameter, parameter_name(value)},
            data("p_axis", text_or_nothing(number)),
            data("value", text_or_nothing(text)),
            data("number", is_number ? exact(value.value.number) : Value()),
            data("unit", text_or_nothing(unit)),
            data("written", value.set() ? Value(written(value)) : Value()),
            shown(labels::value, shown_value(value)),
            {"origin", says::origin, origin_of(value)},
            data("reference", value.referenced),
            data("file", place ? Value(std::string(locate(*place, sources_).file)) : Value()),
            data("line", place ? Value(value.line) : Value()),
            data("usable", !value.unusable),
            data("control_value", control ? text_or_nothing(control->value) : Value()),
            data("control_message", control ? text_or_nothing(control->message) : Value()),
            data("finding", finding != nullptr ? Value(code_text(finding->code)) : Value())};
  }

  validator::LoadedAxis const& axis_;
  SourceSet const& sources_;
  Corrections corrections_;
};

/// Those about values of the axis. Rules about several parameters stand at one of them.
Corrections corrections_of(validator::LoadedAxis const& axis, std::deque<Finding> const& findings) {
  Corrections corrections;
  for (auto const& finding : findings) {
    if (finding.parameter.empty() || !finding.place) continue;
    auto const found = axis.merged.values.catalogue().find_exact(finding.parameter);
    if (!found) continue;
    auto const& value = axis.merged.values[found.slot];
    bool const is_here = value.set() && value.source == finding.place->source;
    bool const is_told = value.unusable || (finding.control && !finding.control->value.empty());
    if (!is_here || !is_told || finding.severity == Severity::note) continue;
    corrections.emplace(finding.parameter, finding);
  }
  return corrections;
}

}  // namespace

Document values_answer(Workspace& workspace, ValuesQuestion const& question) {
  auto const input = machine_of_input(workspace, question.machine);
  SourceSet sources;
  auto loaded = loaded_machine(workspace, input.machine, sources);
  std::deque<Finding> findings;
  static_cast<void>(validator::check(loaded, workspace.files(), workspace.options_of(input.machine), sources,
                                     [&](Finding& finding) { findings.push_back(std::move(finding)); }));
  auto const [index, words] = chosen_axis(loaded, sources, input, question.words);
  if (words.empty() && !question.all) throw Failure({says::name_parameters});
  auto const& axis = loaded.axes[index];
  std::vector<schema::Slot> slots;
  for (auto const& word : words) {
    for (auto const slot : chosen_slots(axis.merged.values, word)) slots.push_back(slot);
  }
  if (question.all) {
    for (auto const* const value : axis.merged.values.set_values()) slots.push_back(value->slot);
  }
  AxisValues const values(axis, sources, corrections_of(axis, findings));
  return {.version = 1,
          .title = Words(says::values_of, {{"axis", axis.name}}),
          .blocks = {Facts{{data("axis", axis.name), data("machine", input.machine)}}, values.table(slots)},
          .csv_table = "values"};
}

}  // namespace axisc
