#include "schema/catalogue.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/indexed_name.hpp"
#include "schema/name_hash.hpp"
#include "schema/name_matching.hpp"
#include "schema/parameter_row.hpp"
#include "schema/plain_values.hpp"
#include "schema/tables/extension.hpp"
#include "schema/tables/kind_tables.hpp"
#include "schema/words.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::schema {
namespace {

/// The parameter of a slot number. Eight bytes, and lists name their parameters more or less in the order of
/// the catalogue, so look-ups read contiguous memory. A longer name does not compile: the tables are written
/// with braces, which narrow nothing.
struct SlotRow {
  std::uint32_t name_begin : 24;  ///< in name_bytes
  std::uint32_t name_size : 8;
  ParameterId parameter;
};
static_assert(sizeof(SlotRow) == 8);

/// A name without any brackets and its rows, which differ in their indices.
struct BareName {
  std::string_view name;
  std::uint16_t first_row = 0;
  std::uint16_t rows = 0;
};

#include "catalogue_tables.inc"

static_assert(std::size(displacement_table) == hash_geometry.buckets);
static_assert(std::size(place_table) == hash_geometry.places);
static_assert(std::size(bare_displacement_table) == bare_hash_geometry.buckets);
static_assert(std::size(bare_place_table) == bare_hash_geometry.places);

constexpr auto plain_table = [] {
  std::array<PlainValues, std::size(parameter_table)> table;
  std::transform(std::begin(parameter_table), std::end(parameter_table), table.begin(), plain_values_of);
  return table;
}();

constexpr std::size_t limited_slots = [] {
  std::size_t count = 0;
  for (Parameter const& parameter : parameter_table) {
    if (is_limited_by_another(parameter)) count += parameter.slots;
  }
  return count;
}();

constexpr auto limited_table = [] {
  std::array<Slot, limited_slots> table;
  auto* next = table.begin();
  for (Parameter const& parameter : parameter_table) {
    if (is_limited_by_another(parameter)) next = write_slots(parameter, next);
  }
  return table;
}();

Parameter const& row(ParameterId id) {
  return parameter_table[static_cast<std::size_t>(id)];
}

SlotRow const& row(Slot slot) {
  return slot_table[static_cast<std::size_t>(slot)];
}

/// The only slot that can have that name.
[[gnu::always_inline]] inline Slot candidate(std::string_view name) {
  std::uint64_t const hash = hash_name(name);
  std::uint16_t const displacement = displacement_table[bucket_of(hash, hash_geometry)];
  return Slot{place_table[place_of(hash, displacement, hash_geometry)]};
}

[[gnu::always_inline]] inline bool is_name_of(SlotRow const& known, std::string_view name) {
  return known.name_size == name.size() &&
         same_bytes(&name_bytes[known.name_begin], name.data(), name.size());
}

NameLookup found(Slot slot) {
  ParameterId const id = parameter_of(slot);
  NameLookup lookup{.status = NameLookup::Status::found, .parameter = id, .row = &row(id), .slot = slot};
  lookup.index = indices_of(slot);
  return lookup;
}

/// The rows whose name without brackets is this one.
std::span<ParameterId const> rows_of_bare_name(std::string_view bare) {
  std::uint64_t const hash = hash_name(bare);
  std::uint16_t const displacement = bare_displacement_table[bucket_of(hash, bare_hash_geometry)];
  BareName const& known = bare_name_table[bare_place_table[place_of(hash, displacement, bare_hash_geometry)]];
  if (!same_bytes(known.name, bare)) return {};
  return std::span(bare_row_table).subspan(known.first_row, known.rows);
}

/// For names that the perfect hash does not know: the row whose name differs in its indices only.
NameLookup find_row(std::string_view text) {
  std::span<ParameterId const> const rows = rows_of_bare_name(bare_name(text));
  if (rows.empty()) return {};
  auto const name = split_name(text);
  return name ? match_name(*name, rows, parameters()).lookup : NameLookup{};
}

/// Case is folded only for names that miss.
template <typename Find>
NameLookup find_folding(std::string_view name, Find find_as_it_stands) {
  NameLookup lookup = find_as_it_stands(name);
  if (lookup.status != NameLookup::Status::unknown || is_lower_case(name)) return lookup;
  lookup = find_as_it_stands(ascii::lower_case(name));
  lookup.case_folded = lookup.status != NameLookup::Status::unknown;
  return lookup;
}

}  // namespace

ConcreteParameter find_exact(std::string_view name) {
  Slot const slot = candidate(name);
  SlotRow const& known = row(slot);
  if (!is_name_of(known, name)) return {};
  return {.row = &row(known.parameter), .slot = slot};
}

void find_plain(std::span<std::string_view const> names, std::span<PlainParameter> found) {
  assert(names.size() <= names_at_once && names.size() <= found.size());
  // Names are too far apart for the nearest cache, so all of them are prefetched before the first is
  // compared.
  for (std::size_t i = 0; i < names.size(); ++i) {
    found[i].slot = candidate(names[i]);
    SlotRow const& known = row(found[i].slot);
    __builtin_prefetch(&name_bytes[known.name_begin]);
    __builtin_prefetch(&plain_table[static_cast<std::size_t>(known.parameter)]);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    SlotRow const& known = row(found[i].slot);
    found[i].values =
        is_name_of(known, names[i]) ? &plain_table[static_cast<std::size_t>(known.parameter)] : nullptr;
  }
}

std::span<Slot const> slots_limited_by_others() {
  return limited_table;
}

NameLookup find_as_written(std::string_view name) {
  if (auto const exact = find_exact(name)) return found(exact.slot);
  return find_row(name);
}

std::span<Parameter const> parameters() {
  return parameter_table;
}

Parameter const& parameter(ParameterId id) {
  return row(id);
}

std::size_t slot_count() {
  return std::size(slot_table);
}

NameLookup find(std::string_view name) {
  return find_folding(name, find_as_written);
}

std::span<ParameterId const> find_number(std::uint16_t p_axis) {
  if (p_axis + std::size_t{1} >= std::size(number_start_table)) return {};
  std::size_t const begin = number_start_table[p_axis];
  std::size_t const end = number_start_table[p_axis + std::size_t{1}];
  return std::span(number_table).subspan(begin, end - begin);
}

ParameterId parameter_of(Slot slot) {
  return row(slot).parameter;
}

Indices indices_of(Slot slot) {
  return indices_of(row(parameter_of(slot)), slot);
}

std::string slot_name(Slot slot) {
  SlotRow const& known = row(slot);
  return {&name_bytes[known.name_begin], known.name_size};
}

Slot slot_of(ParameterId id, std::uint32_t first_index, std::uint32_t second_index) {
  return slot_of(row(id), first_index, second_index);
}

Indices indices_of(Parameter const& parameter, Slot slot) {
  auto entry = static_cast<std::uint32_t>(slot) - static_cast<std::uint32_t>(parameter.first_slot);
  Indices indices{};
  for (std::size_t i = parameter.index_count(); i-- > 1;) {
    indices.at(i) = entry % parameter.array.at(i);
    entry /= parameter.array.at(i);
  }
  indices.front() = entry;
  return indices;
}

Slot slot_of(Parameter const& parameter, std::uint32_t first_index, std::uint32_t second_index) {
  return slot_of(parameter, Indices{first_index, second_index, 0});
}

Slot slot_of(Parameter const& parameter, Indices const& indices) {
  std::uint32_t entry = indices.front();
  for (std::size_t i = 1; i < parameter.index_count(); ++i) {
    entry = entry * parameter.array.at(i) + indices.at(i);
  }
  return static_cast<Slot>(static_cast<std::uint32_t>(parameter.first_slot) + entry);
}

std::string slot_name(Parameter const& parameter, Slot slot) {
  if (parameter.index_count() == 0) return std::string(parameter.name);
  bool const is_built_in = parameter.kind == ListKind::axis &&
                           static_cast<std::size_t>(slot) < schema::slot_count() &&
                           &row(row(slot).parameter) == &parameter;
  if (is_built_in) return slot_name(slot);
  auto const indices = indices_of(parameter, slot);
  constexpr std::size_t digits = 5;
  std::string name;
  name.reserve(parameter.name.size() + indices.size() * digits);
  std::string_view rest = parameter.name;
  for (std::uint32_t const index : indices) {
    std::size_t const bracket = rest.find('[');
    if (bracket == std::string_view::npos) break;
    name.append(rest.substr(0, bracket + 1)).append(std::to_string(index));
    rest.remove_prefix(bracket + 1);
  }
  return name.append(rest);
}

bool is_symbol_of_any_parameter(std::string_view word) {
  return std::binary_search(std::begin(word_table), std::end(word_table), word);
}

Catalogue Catalogue::of(ListKind kind) {
  Catalogue catalogue;
  if (kind != ListKind::axis) catalogue.own_ = kind_tables(kind);
  return catalogue;
}

Catalogue Catalogue::with(std::vector<ParameterRow> rows) const {
  std::vector<ParameterRow> all;
  if (own_) {
    for (ParameterRow const& own : own_->own_rows()) {
      auto const is_same = [&own](ParameterRow const& row) { return row.name == own.name; };
      if (std::none_of(rows.begin(), rows.end(), is_same)) all.push_back(own);
    }
  }
  std::move(rows.begin(), rows.end(), std::back_inserter(all));
  Catalogue result;
  result.own_ = std::make_shared<Extension const>(std::move(all));
  return result;
}

std::span<Parameter const> Catalogue::parameters() const {
  return own_ ? own_->parameters() : schema::parameters();
}

Parameter const& Catalogue::parameter_of(Slot slot) const {
  return parameter(own_ ? own_->parameter_of(slot) : schema::parameter_of(slot));
}

std::size_t Catalogue::slot_count() const {
  return own_ ? own_->slot_count() : schema::slot_count();
}

NameLookup Catalogue::find(std::string_view name) const {
  if (!own_) return schema::find(name);
  return find_folding(name, [this](std::string_view text) { return own_->find_as_written(text); });
}

ConcreteParameter Catalogue::find_exact(std::string_view name) const {
  if (is_built_in()) return schema::find_exact(name);
  NameLookup const lookup = own_->find_as_written(name);
  if (lookup.status != NameLookup::Status::found) return {};
  return {.row = lookup.row, .slot = lookup.slot};
}

void Catalogue::find_plain(std::span<std::string_view const> names, std::span<PlainParameter> found) const {
  if (is_built_in()) return schema::find_plain(names, found);
  std::transform(names.begin(), names.end(), found.begin(),
                 [this](std::string_view name) { return own_->find_plain(name); });
}

std::span<Slot const> Catalogue::slots_limited_by_others() const {
  return own_ ? own_->slots_limited_by_others() : schema::slots_limited_by_others();
}

std::span<ParameterId const> Catalogue::find_number(std::uint16_t p_axis) const {
  return own_ ? own_->find_number(p_axis) : schema::find_number(p_axis);
}

bool Catalogue::is_symbol_of_any_parameter(std::string_view word) const {
  bool const is_own = own_ && own_->knows_word(word);
  return is_own || (kind() == ListKind::axis && schema::is_symbol_of_any_parameter(word));
}

NameSuggestions Catalogue::suggest_names(std::string_view name) const {
  return own_ ? schema::suggest_names(own_->vocabulary(), name) : schema::suggest_names(name);
}

std::string_view Catalogue::file_of(Parameter const& parameter) const {
  return own_ ? own_->file_of(parameter.name) : std::string_view();
}

ListKind Catalogue::kind() const {
  return own_ ? own_->kind() : ListKind::axis;
}

}  // namespace axisc::schema
