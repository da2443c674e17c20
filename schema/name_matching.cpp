#include "schema/name_matching.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace axisc::schema {
namespace {

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
NameLookup check_range(IndexedName const& name, ParameterId id, Parameter const& parameter) {
  NameLookup lookup{.status = NameLookup::Status::found, .parameter = id, .row = &parameter};
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
  if (lookup.status == NameLookup::Status::found) {
    lookup.slot = slot_of(parameter, lookup.index);
  }
  return lookup;
}

}  // namespace

NameMatch match_name(IndexedName const& name, std::span<ParameterId const> candidates,
                     std::span<Parameter const> rows) {
  std::optional<ParameterId> nearest;
  IndexMismatch smallest;
  for (ParameterId const candidate : candidates) {
    Parameter const& parameter = rows[static_cast<std::size_t>(candidate)];
    IndexMismatch const mismatch = compare_indices(name, parameter);
    if (mismatch.differences == 0) {
      return {.exact = true, .lookup = check_range(name, candidate, parameter)};
    }
    if (!nearest || mismatch.differences < smallest.differences) {
      nearest = candidate;
      smallest = mismatch;
    }
  }
  if (!nearest) return {};
  Parameter const& parameter = rows[static_cast<std::size_t>(*nearest)];
  NameLookup lookup{.parameter = *nearest, .row = &parameter};
  if (smallest.missing) {
    lookup.status = NameLookup::Status::index_missing;
    lookup.index_position = static_cast<std::uint8_t>(*smallest.missing);
    lookup.array_size = parameter.array.at(*smallest.missing);
  } else {
    lookup.status = NameLookup::Status::index_superfluous;
    lookup.index_position = static_cast<std::uint8_t>(
        std::min<std::size_t>(*smallest.superfluous, std::numeric_limits<std::uint8_t>::max()));
  }
  return {.exact = false, .lookup = lookup};
}

}  // namespace axisc::schema
