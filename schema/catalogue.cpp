#include "schema/catalogue.hpp"

#include "schema/ascii.hpp"
#include "schema/indexed_name.hpp"
#include "schema/name_hash.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axisc::schema {
namespace {

/// What a slot number stands for.
struct SlotRow {
  ParameterId parameter{};
  std::array<std::uint16_t, 2> index{};
};

/// A row's name without any brackets.
struct BareName {
  std::string_view name;
  ParameterId parameter{};
};

#include "catalogue_tables.inc"

static_assert(std::size(slot_table) == std::size(slot_name_table));
static_assert(std::size(displacement_table) == hash_geometry.buckets);
static_assert(std::size(place_table) == hash_geometry.places);

Parameter const& row(ParameterId id) {
  return parameter_table[static_cast<std::size_t>(id)];
}

std::optional<Slot> find_slot(std::string_view name) {
  std::uint64_t const hash = hash_name(name);
  std::uint16_t const displacement = displacement_table[bucket_of(hash, hash_geometry)];
  std::uint16_t const entry = place_table[place_of(hash, displacement, hash_geometry)];
  if (entry == 0 || slot_name_table[entry - 1] != name) return std::nullopt;
  return static_cast<Slot>(entry - 1);
}

NameLookup found(Slot slot) {
  NameLookup lookup{.status = NameLookup::Status::found, .parameter = parameter_of(slot), .slot = slot};
  lookup.index = indices_of(slot);
  return lookup;
}

/// Where the indices of a name and those that a row asks for differ.
struct IndexMismatch {
  std::size_t differences = 0;
  std::optional<std::size_t> missing;      ///< first index of the row that the name lacks
  std::optional<std::size_t> superfluous;  ///< first index of the name that the row lacks
};

IndexMismatch compare_indices(IndexedName const& name, Parameter const& parameter) {
  IndexMismatch mismatch;
  std::size_t in_row = 0;
  std::size_t in_name = 0;
  std::string_view pattern = parameter.name;
  for (NamePart const& part : name.parts) {
    bool const wanted = take_part(pattern).ends_with("[]");
    if (wanted != part.index.has_value()) {
      ++mismatch.differences;
      if (wanted && !mismatch.missing) mismatch.missing = in_row;
      if (!wanted && !mismatch.superfluous) mismatch.superfluous = in_name;
    }
    if (wanted) ++in_row;
    if (part.index) ++in_name;
  }
  return mismatch;
}

/// The name has exactly the indices that the row asks for; they may be out of range.
NameLookup check_range(IndexedName const& name, ParameterId id) {
  NameLookup lookup{.status = NameLookup::Status::found, .parameter = id};
  Parameter const& parameter = row(id);
  std::size_t position = 0;
  for (NamePart const& part : name.parts) {
    if (!part.index) continue;
    lookup.index.at(position) = *part.index;
    if (lookup.status == NameLookup::Status::found && *part.index >= parameter.array.at(position)) {
      lookup.status = NameLookup::Status::index_out_of_range;
      lookup.index_position = static_cast<std::uint8_t>(position);
      lookup.array_size = parameter.array.at(position);
    }
    ++position;
  }
  if (lookup.status == NameLookup::Status::found) lookup.slot = slot_of(id, lookup.index[0], lookup.index[1]);
  return lookup;
}

/// For names that the perfect hash does not know: the row whose name differs in its indices only.
NameLookup find_row(std::string_view text) {
  auto const name = split_name(text);
  if (!name) return {};
  std::string const bare = bare_name(*name);
  auto const rows =
      std::equal_range(std::begin(bare_name_table), std::end(bare_name_table), BareName{.name = bare},
                       [](BareName const& a, BareName const& b) { return a.name < b.name; });
  std::optional<ParameterId> nearest;
  IndexMismatch smallest;
  for (auto const* candidate = rows.first; candidate != rows.second; ++candidate) {
    IndexMismatch const mismatch = compare_indices(*name, row(candidate->parameter));
    if (mismatch.differences == 0) return check_range(*name, candidate->parameter);
    if (!nearest || mismatch.differences < smallest.differences) {
      nearest = candidate->parameter;
      smallest = mismatch;
    }
  }
  if (!nearest) return {};
  if (smallest.missing) {
    return {.status = NameLookup::Status::index_missing,
            .parameter = *nearest,
            .index_position = static_cast<std::uint8_t>(*smallest.missing),
            .array_size = row(*nearest).array.at(*smallest.missing)};
  }
  auto const position =
      std::min<std::size_t>(*smallest.superfluous, std::numeric_limits<std::uint8_t>::max());
  return {.status = NameLookup::Status::index_superfluous,
          .parameter = *nearest,
          .index_position = static_cast<std::uint8_t>(position)};
}

NameLookup find_as_written(std::string_view name) {
  if (auto const slot = find_slot(name)) return found(*slot);
  return find_row(name);
}

}  // namespace

std::string_view data_type_name(DataType type) {
  constexpr std::array<std::string_view, 11> names = {"BOOLEAN", "UNS08", "UNS16", "UNS32",  "UNS64", "SGN08",
                                                      "SGN16",   "SGN32", "SGN64", "REAL64", "STRING"};
  return names.at(static_cast<std::size_t>(type));
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

std::string p_axis_text(std::uint16_t number) {
  if (number == 0) return {};
  std::string const digits = std::to_string(number);
  return "P-AXIS-" + std::string(5 - digits.size(), '0') + digits;
}

NameLookup find(std::string_view name) {
  NameLookup lookup = find_as_written(name);
  if (lookup.status != NameLookup::Status::unknown) return lookup;
  std::string const folded = lower_case(name);
  if (folded == name) return lookup;
  lookup = find_as_written(folded);
  lookup.case_folded = lookup.status != NameLookup::Status::unknown;
  return lookup;
}

std::span<ParameterId const> find_number(std::uint16_t p_axis) {
  if (p_axis + std::size_t{1} >= std::size(number_start_table)) return {};
  std::size_t const begin = number_start_table[p_axis];
  std::size_t const end = number_start_table[p_axis + std::size_t{1}];
  return std::span(number_table).subspan(begin, end - begin);
}

ParameterId parameter_of(Slot slot) {
  return slot_table[static_cast<std::size_t>(slot)].parameter;
}

std::array<std::uint32_t, 2> indices_of(Slot slot) {
  auto const& index = slot_table[static_cast<std::size_t>(slot)].index;
  return {index[0], index[1]};
}

std::string slot_name(Slot slot) {
  return std::string(slot_name_table[static_cast<std::size_t>(slot)]);
}

Slot slot_of(ParameterId id, std::uint32_t first_index, std::uint32_t second_index) {
  Parameter const& parameter = row(id);
  std::uint32_t const row_size = parameter.array[1] == 0 ? 1 : parameter.array[1];
  return static_cast<Slot>(static_cast<std::uint32_t>(parameter.first_slot) + first_index * row_size +
                           second_index);
}

bool is_symbol_of_any_parameter(std::string_view word) {
  return std::binary_search(std::begin(word_table), std::end(word_table), word);
}

}  // namespace axisc::schema
