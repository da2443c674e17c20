#include "axisc/answers/values/set_values.hpp"

#include "axisc/answers/values/chosen_values.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/workspace/changeable_files.hpp"
#include "axisc/workspace/edited_files.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/fingerprint.hpp"
#include "diagnostics/fix_batch.hpp"
#include "schema/data_type.hpp"
#include "schema/value.hpp"
#include "validator/check.hpp"
#include "validator/views/units_text.hpp"
#include "validator/views/written_unit.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace axisc::says {

constexpr Sentence name_assignments{"name a parameter and its value: filter[0].fg_f0=48Hz",
                                    "einen Parameter mit seinem Wert nennen: filter[0].fg_f0=48Hz"};
constexpr Sentence no_value{"\"{word}\" has no value; write {word}=VALUE",
                            "„{word}“ hat keinen Wert; {word}=WERT schreiben"};
constexpr Sentence twice{"`{name}` is given twice", "`{name}` ist zweimal angegeben"};
constexpr Sentence other_unit{
    "\"{unit}\" is not a unit of `{name}`, whose number is in {expected}; without a unit it is written as it "
    "is",
    "„{unit}“ ist keine Einheit von `{name}`, dessen Zahl in {expected} gilt; ohne Einheit wird sie "
    "unverändert geschrieben"};
constexpr Sentence no_unit{"`{name}` has no unit: write the number alone",
                           "`{name}` hat keine Einheit: nur die Zahl schreiben"};
constexpr Sentence not_whole{"{value} is not a whole number in {expected}, as `{name}` needs it",
                             "{value} ist keine ganze Zahl in {expected}, wie `{name}` sie braucht"};
constexpr Sentence cannot_edit{"{file} cannot be edited: write the lines into it by hand",
                               "{file} kann nicht bearbeitet werden: die Zeilen von Hand eintragen"};
constexpr Sentence not_encoded{
    "`{name}` cannot be \"{value}\": {file} is in windows-1252, which lacks a character of it",
    "`{name}` kann nicht „{value}“ sein: {file} ist in windows-1252, wo ein Zeichen davon fehlt"};
constexpr Sentence outside{"{file} lies outside what the command line names: name it, or its folder",
                           "{file} liegt außerhalb dessen, was die Befehlszeile nennt: die Liste oder ihren "
                           "Ordner nennen"};
constexpr Sentence not_one_value{
    "\"{value}\" cannot be written as the value of `{name}`: a list reads something else",
    "„{value}“ kann nicht als Wert von `{name}` geschrieben werden: eine Liste liest "
    "etwas anderes"};
constexpr Sentence shared{"axis {axis} reads the same list: it gets the values as well",
                          "Achse {axis} liest dieselbe Liste: auch sie erhält die Werte"};

}  // namespace axisc::says

namespace axisc {

namespace {

using validator::EffectiveValue;

/// "48.5" and "Hz"; all of it is a number, or a word, where there is no unit.
std::pair<std::string, std::string> number_and_unit(std::string const& text) {
  auto const begin = text.find_first_not_of("+-0123456789.eE");
  auto const digits = text.substr(0, begin);
  bool const is_number = schema::read_real(digits).status == schema::NumberStatus::good;
  if (begin == std::string::npos || !is_number) return {text, ""};
  return {digits, std::string(ascii::trimmed(text.substr(begin)))};
}

/// As the list has it.
std::string list_text(EffectiveValue const& value, machine::AxisType type, std::string const& text) {
  auto const& row = *value.row;
  if (!row.symbols.empty()) {
    auto const* const symbol = schema::read_symbol(row, text).symbol;
    return symbol != nullptr ? std::string(symbol->word) : text;
  }
  if (row.type == schema::DataType::string) return text;
  auto const [digits, unit] = number_and_unit(text);
  if (unit.empty() || !validator::is_unit(unit)) return text;
  auto const name = parameter_name(value);
  auto const expected = validator::unit_of(row, type);
  if (expected.empty()) throw Failure({says::no_unit, {{"name", name}}});
  auto const ratio = validator::unit_ratio(unit, expected);
  auto const expected_name = validator::unit_name(expected);
  if (!ratio) {
    throw Failure({says::other_unit, {{"unit", unit}, {"name", name}, {"expected", expected_name}}});
  }
  auto const number = schema::read_real(digits).number;
  auto converted = validator::converted_number(number, *ratio, schema::is_integer(row.type));
  if (converted.empty()) {
    throw Failure({says::not_whole, {{"value", text}, {"name", name}, {"expected", expected_name}}});
  }
  return converted;
}

/// The list of the axis gives this value already, whatever its notation.
bool is_written_so(EffectiveValue const& value, SourceSet const& sources, std::string const& text) {
  if (value.origin != validator::Origin::axis_list || !value.has_value) return false;
  if (sources[value.source].utf8(value.value_span) == text) return true;
  auto const number = schema::read_real(text);
  return number.status == schema::NumberStatus::good && !value.unusable && !value.referenced &&
         value.value.text.empty() && value.value.number == number.number;
}

std::vector<tuning::ListLine> lines_of(validator::LoadedAxis const& axis, SourceSet const& sources,
                                       std::vector<std::string> const& words) {
  if (words.empty()) throw Failure({says::name_assignments});
  auto const& values = axis.merged.values;
  std::vector<tuning::ListLine> lines;
  for (auto const& word : words) {
    auto const equals = word.find('=');
    auto const name = word.substr(0, equals);
    if (equals == std::string::npos || equals + 1 == word.size()) {
      throw Failure({says::no_value, {{"word", name}}});
    }
    auto const& value = values[chosen_slot(values.catalogue(), name)];
    auto const full_name = parameter_name(value);
    bool const is_again = std::any_of(lines.begin(), lines.end(),
                                      [&](tuning::ListLine const& line) { return line.name == full_name; });
    if (is_again) throw Failure({says::twice, {{"name", full_name}}});
    lines.push_back({.name = full_name, .value = list_text(value, axis.type, word.substr(equals + 1))});
  }
  std::erase_if(lines, [&](tuning::ListLine const& line) {
    return is_written_so(values[values.catalogue().find_exact(line.name).slot], sources, line.value);
  });
  return lines;
}

/// Failure for a value that would not be read again as it was given: one with a line end or a comment.
void require_read_back(Workspace& workspace, std::string const& path, EditedBytes const& edited,
                       std::size_t axis, std::vector<tuning::ListLine> const& lines) {
  EditedFiles files(edited, workspace.files());
  SourceSet sources;
  auto read = validator::load(files, path, workspace.options_of(path), sources);
  auto const* const machine = std::get_if<validator::LoadedMachine>(&read);
  for (auto const& [name, text] : lines) {
    auto const* const values = machine != nullptr ? &machine->axes[axis].merged.values : nullptr;
    auto const* const value =
        values != nullptr ? &(*values)[values->catalogue().find_exact(name).slot] : nullptr;
    bool const is_same = value != nullptr && (!value->set() || !value->has_value ||
                                              sources[value->source].utf8(value->value_span) == text);
    if (!is_same) throw Failure({says::not_one_value, {{"value", text}, {"name", name}}});
  }
}

/// Errors of the edited lists that the present ones do not have, and those about what was set.
class NewErrors {
 public:
  NewErrors(Workspace& workspace, std::string const& path) : workspace_(workspace), path_(path) {
    SourceSet sources;
    check({}, sources, [&](Finding const& finding) { ++before_[identity_of(finding, sources)]; });
  }

  /// True if there was one.
  [[nodiscard]] bool take(EditedBytes const& edited, std::vector<tuning::ListLine> const& lines,
                          ErrorSink const& errors) const {
    SourceSet sources;
    auto before = before_;
    std::vector<Finding> found;
    check(edited, sources, [&](Finding& finding) {
      auto& known = before[identity_of(finding, sources)];
      bool const is_about_them = std::any_of(lines.begin(), lines.end(), [&](tuning::ListLine const& line) {
        return line.name == finding.parameter;
      });
      if (known > 0 && !is_about_them) {
        --known;
      } else if (finding.severity == Severity::error) {
        found.push_back(std::move(finding));
      }
    });
    if (!found.empty()) errors.take(found, sources);
    return !found.empty();
  }

 private:
  template <class Take>
  void check(EditedBytes const& edited, SourceSet& sources, Take take) const {
    EditedFiles files(edited, workspace_.files());
    static_cast<void>(validator::check(files, path_, workspace_.options_of(path_), sources, take));
  }

  Workspace& workspace_;
  std::string const& path_;
  std::map<Identity, std::size_t> before_;
};

std::vector<Message> notes_about(validator::LoadedMachine const& machine, std::size_t axis) {
  std::vector<Message> notes;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    if (i == axis || machine.axes[i].list != machine.axes[axis].list) continue;
    notes.push_back({says::shared, {{"axis", machine.axes[i].name}}});
  }
  return notes;
}

/// Why the list of an axis cannot get some of these lines.
Failure refused_edit(validator::LoadedMachine const& machine, std::size_t axis, SourceSet const& sources,
                     std::vector<tuning::ListLine> const& lines) {
  auto const& source = sources[machine.lists[machine.axes[axis].list].list.source];
  for (auto const& [name, text] : lines) {
    if (can_be_written(source, text)) continue;
    return Failure({says::not_encoded, {{"name", name}, {"value", text}, {"file", source.name()}}});
  }
  return Failure({says::cannot_edit, {{"file", source.name()}}});
}

}  // namespace

std::optional<NewValues> set_values(Workspace& workspace, SetQuestion const& question,
                                    ErrorSink const& errors) {
  auto const input = machine_of_input(workspace, question.machine);
  SourceSet sources;
  auto const machine = loaded_machine(workspace, input.machine, sources);
  auto const [axis, words] = chosen_axis(machine, sources, input, question.words);
  auto const lines = lines_of(machine.axes[axis], sources, words);
  NewValues made{.edits = edit_lists(machine, {{axis, lines}}, sources, Defaults::written),
                 .notes = notes_about(machine, axis)};
  if (made.edits.refused) throw refused_edit(machine, axis, sources, lines);
  if (made.edits.edited.empty()) return made;
  ChangeableFiles const changeable({question.machine.input});
  for (auto const& [path, bytes] : made.edits.edited) {
    if (!changeable.contains(path)) throw Failure({says::outside, {{"file", path}}});
  }
  require_read_back(workspace, input.machine, made.edits.edited, axis, lines);
  if (NewErrors(workspace, input.machine).take(made.edits.edited, lines, errors)) return std::nullopt;
  return made;
}

}  // namespace axisc
