// The row that a name with indices means, among rows that differ in their indices only.
#pragma once

#include "schema/catalogue.hpp"
#include "schema/indexed_name.hpp"

#include <span>

namespace axisc::schema {

struct NameMatch {
  bool exact = false;  ///< the name has the indices that a row asks for; they may be out of range
  NameLookup lookup;   ///< unknown where there are no `candidates`
};

/// `candidates` are indices into `rows`.
[[nodiscard]] NameMatch match_name(IndexedName const& name, std::span<ParameterId const> candidates,
                                   std::span<Parameter const> rows);

}  // namespace axisc::schema
