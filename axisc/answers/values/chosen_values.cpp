#include "axisc/answers/values/chosen_values.hpp"

#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/explain/explain_subject.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/image_file.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace axisc::says {

constexpr Sentence which_axis_of{"name the axis: {axes}", "die Achse nennen: {axes}"};
constexpr Sentence no_such_parameter{
    "there is no axis parameter \"{name}\"; `axisc explain` finds names by what they mean",
    "es gibt keinen Achsparameter „{name}“; `axisc explain` findet Namen nach ihrer Bedeutung"};
constexpr Sentence no_such_parameter_meant{"there is no axis parameter \"{name}\"; did you mean {meant}?",
                                           "es gibt keinen Achsparameter „{name}“; war {meant} gemeint?"};
constexpr Sentence index_needed{"there is no `{name}`; write one of {first} to {last}",
                                "`{name}` gibt es nicht; einen Eintrag von {first} bis {last} angeben"};

}  // namespace axisc::says

namespace axisc {

namespace {

using validator::EffectiveValues;

std::string names_of(validator::LoadedMachine const& machine) {
  std::string names;
  for (auto const& axis : machine.axes) names += (names.empty() ? "" : ", ") + axis.name;
  return names;
}

/// A slot that a list sets, or else the first one.
void add_slots(std::vector<schema::Slot>& slots, EffectiveValues const& values,
               schema::Parameter const& row) {
  auto const before = slots.size();
  std::vector<schema::Slot> all(row.slots);
  schema::write_slots(row, all.begin());
  std::copy_if(all.begin(), all.end(), std::back_inserter(slots),
               [&](schema::Slot slot) { return values.is_set(slot); });
  if (slots.size() == before) slots.push_back(row.first_slot);
}

/// `filter[0]` begins `filter[0].order`.
bool begins(std::string_view name, std::string_view beginning) {
  bool const is_longer = name.size() > beginning.size() && name.starts_with(beginning);
  return is_longer && (name[beginning.size()] == '.' || name[beginning.size()] == '[');
}

/// What numbers and words lead to, as lists have it.
std::string found_names(schema::Catalogue const& catalogue, std::string const& name) {
  constexpr std::size_t most = 3;
  std::vector<std::string> names;
  auto const add = [&names](schema::Parameter const& row) {
    if (names.size() < most) names.push_back(schema::slot_name(row, row.first_slot));
  };
  std::vector const catalogues{catalogue};
  auto const subject = find_subject(catalogues, name);
  for (auto const* const row : subject.parameters) add(*row);
  for (auto const& hit : subject.hits) {
    auto const* const row = std::get_if<schema::Parameter const*>(&hit.subject);
    if (row != nullptr && hit.likeness < Likeness::some_words) add(**row);
  }
  return joined(names, ", ");
}

[[noreturn]] void refuse(schema::Catalogue const& catalogue, std::string const& name) {
  auto const near = catalogue.suggest_names(name).names;
  auto const meant = near.empty() ? found_names(catalogue, name) : near.front();
  throw Failure({meant.empty() ? says::no_such_parameter : says::no_such_parameter_meant,
                 {{"name", name}, {"meant", meant}}});
}

/// `filter[9].order`, of which there are three.
[[noreturn]] void refuse_index(schema::Parameter const& row, std::string const& name) {
  auto const last = static_cast<schema::Slot>(static_cast<std::uint32_t>(row.first_slot) + row.slots - 1U);
  throw Failure({says::index_needed,
                 {{"name", name},
                  {"first", schema::slot_name(row, row.first_slot)},
                  {"last", schema::slot_name(row, last)}}});
}

/// `filter[].order` without its empty brackets, which no list has.
std::string without_empty_brackets(std::string name) {
  for (auto at = name.find("[]"); at != std::string::npos; at = name.find("[]")) name.erase(at, 2);
  return name;
}

bool names_entry(std::string_view name) {
  auto const bracket = name.find('[');
  return bracket != std::string_view::npos && bracket + 1 < name.size() && ascii::is_digit(name[bracket + 1]);
}

/// Names consist of identifiers and indices; the catalogue takes no others.
bool is_name(std::string_view word) {
  return word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]") ==
         std::string_view::npos;
}

}  // namespace

ChosenAxis chosen_axis(validator::LoadedMachine const& machine, SourceSet const& sources,
                       Belonging const& input, std::vector<std::string> words) {
  for (std::size_t i = 0; i < machine.axes.size() && !words.empty(); ++i) {
    if (machine.axes[i].name != words.front()) continue;
    words.erase(words.begin());
    return {.axis = i, .words = std::move(words)};
  }
  std::optional<std::size_t> only;
  if (machine.axes.size() == 1) only = 0;
  if (!only && input.name != input.machine) only = axis_of_list(machine, sources, input.name);
  bool const names_parameter = words.size() < 2 || words.front().find_first_of(".-=[") != std::string::npos;
  if (only && names_parameter) return {.axis = *only, .words = std::move(words)};
  if (words.empty()) throw Failure({says::which_axis_of, {{"axes", names_of(machine)}}});
  std::vector<std::string> names;
  for (auto const& axis : machine.axes) names.push_back(axis.name);
  throw unknown_axis(words.front(), names);
}

std::vector<schema::Slot> chosen_slots(EffectiveValues const& values, std::string const& word) {
  using Status = schema::NameLookup::Status;
  auto const& catalogue = values.catalogue();
  std::vector<schema::Slot> slots;
  if (is_name(word)) {
    auto const found = catalogue.find(without_empty_brackets(word));
    if (found.status == Status::found) return {found.slot};
    if (found.status == Status::index_out_of_range) refuse_index(*found.row, word);
    if (found.row != nullptr && found.status == Status::index_missing) add_slots(slots, values, *found.row);
    if (!slots.empty()) return slots;
    for (auto const* const value : values.set_values()) {
      if (begins(parameter_name(*value), word)) slots.push_back(value->slot);
    }
    if (!slots.empty()) return slots;
    // Other entries are no answer to "filter[9].typ".
    if (names_entry(word)) refuse(catalogue, word);
  }
  std::vector const catalogues{catalogue};
  auto const subject = find_subject(catalogues, word);
  for (auto const* const row : subject.parameters) add_slots(slots, values, *row);
  if (slots.empty()) refuse(catalogue, word);
  return slots;
}

schema::Slot chosen_slot(schema::Catalogue const& catalogue, std::string const& name) {
  using Status = schema::NameLookup::Status;
  if (!is_name(name)) refuse(catalogue, name);
  auto const found = catalogue.find(without_empty_brackets(name));
  if (found.status == Status::found && !found.case_folded) return found.slot;
  bool const has_row = found.row != nullptr && found.status != Status::found;
  if (has_row && found.row->index_count() > 0) refuse_index(*found.row, name);
  if (found.row != nullptr) {
    throw Failure({says::no_such_parameter_meant,
                   {{"name", name}, {"meant", schema::slot_name(*found.row, found.row->first_slot)}}});
  }
  refuse(catalogue, name);
}

}  // namespace axisc
