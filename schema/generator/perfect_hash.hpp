// Search for the displacements of a perfect hash (see schema/name_hash.hpp).
#pragma once

#include "schema/name_hash.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::schema::generator {

struct PerfectHash {
  HashGeometry geometry;
  std::vector<std::uint16_t> displacements;  ///< per bucket
  std::vector<std::uint16_t> entries;        ///< per place: index of the name, 0 where the place is free
};

/// `names` are distinct. Throws std::runtime_error when no displacement is found, which would take two names
/// with the same 64 bit hash or a far larger set.
[[nodiscard]] PerfectHash make_perfect_hash(std::vector<std::string> const& names);

}  // namespace axisc::schema::generator
