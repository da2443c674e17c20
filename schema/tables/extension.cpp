#include "schema/tables/extension.hpp"

#include "schema/indexed_name.hpp"
#include "schema/name_matching.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace axisc::schema {
namespace {

std::vector<Symbol> symbols_of(ParameterRow::Words const& words) {
  std::vector<Symbol> symbols;
  symbols.reserve(words.size());
  for (auto const& [word, number] : words) symbols.push_back({.word = word, .number = number});
  return symbols;
}

}  // namespace

Extension::Extension(std::vector<ParameterRow> rows)
    : own_(std::move(rows)), rows_(schema::parameters().begin(), schema::parameters().end()) {
  for (ParameterRow const& row : own_) add(row);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    auto const id = static_cast<ParameterId>(i);
    if (rows_[i].p_axis != 0) by_number_[rows_[i].p_axis].push_back(id);
    if (is_limited_by_another(rows_[i])) write_slots(rows_[i], std::back_inserter(limited_));
    plain_.push_back(plain_values_of(rows_[i]));
  }
}

void Extension::add(ParameterRow const& row) {
  Parameter parameter = row.view();
  parameter.symbols = symbols_.emplace_back(symbols_of(row.symbols));
  parameter.number_names = symbols_.emplace_back(symbols_of(row.number_names));
  auto const known = std::find_if(rows_.begin(), rows_.end(),
                                  [&](Parameter const& each) { return each.name == parameter.name; });
  auto const id = static_cast<ParameterId>(known - rows_.begin());
  if (known != rows_.end() && known->array == parameter.array) {
    parameter.first_slot = known->first_slot;
  } else {
    parameter.first_slot = static_cast<Slot>(slot_count());
    own_slots_.insert(own_slots_.end(), parameter.slots, id);
  }
  if (known != rows_.end()) {
    *known = parameter;
  } else {
    rows_.push_back(parameter);
  }
  own_ids_.insert(id);
  own_by_bare_name_[without_brackets(row.name)].push_back(id);
  for (auto const& [word, number] : row.symbols) words_.insert(word);
}

std::size_t Extension::slot_count() const {
  return schema::slot_count() + own_slots_.size();
}

NameLookup Extension::find_as_written(std::string_view text) const {
  auto const name = split_name(text);
  if (!name) return {};
  NameMatch own;
  auto const named = own_by_bare_name_.find(bare_name(text));
  if (named != own_by_bare_name_.end()) own = match_name(*name, named->second, rows_);
  if (own.exact) return own.lookup;
  NameLookup built_in = schema::find_as_written(text);
  if (built_in.status == NameLookup::Status::unknown || own_ids_.contains(built_in.parameter)) {
    return own.lookup;
  }
  built_in.row = &rows_[static_cast<std::size_t>(built_in.parameter)];
  return built_in;
}

PlainParameter Extension::find_plain(std::string_view name) const {
  ConcreteParameter const built_in = schema::find_exact(name);
  if (built_in) {
    ParameterId const id = schema::parameter_of(built_in.slot);
    if (!own_ids_.contains(id)) {
      return {.values = &plain_[static_cast<std::size_t>(id)], .slot = built_in.slot};
    }
  }
  NameLookup const lookup = find_as_written(name);
  bool const is_exact =
      lookup.status == NameLookup::Status::found && slot_name(*lookup.row, lookup.slot) == name;
  if (!is_exact) return {};
  return {.values = &plain_[static_cast<std::size_t>(lookup.parameter)], .slot = lookup.slot};
}

std::span<ParameterId const> Extension::find_number(std::uint16_t p_axis) const {
  auto const found = by_number_.find(p_axis);
  return found == by_number_.end() ? std::span<ParameterId const>{} : found->second;
}

ParameterId Extension::parameter_of(Slot slot) const {
  auto const index = static_cast<std::size_t>(slot);
  std::size_t const built_in = schema::slot_count();
  return index < built_in ? schema::parameter_of(slot) : own_slots_[index - built_in];
}

Vocabulary Extension::vocabulary() const {
  std::call_once(taken_apart_, [this] {
    std::vector<std::string> names;
    names.reserve(rows_.size());
    for (Parameter const& row : rows_) names.emplace_back(row.name);
    vocabulary_ = std::make_unique<VocabularyTables>(names);
  });
  return vocabulary_->view(rows_);
}

std::string_view Extension::file_of(std::string_view name) const {
  auto const row =
      std::find_if(own_.begin(), own_.end(), [&](ParameterRow const& each) { return each.name == name; });
  return row == own_.end() ? std::string_view() : std::string_view(row->file);
}

}  // namespace axisc::schema
