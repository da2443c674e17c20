// Whether two lists were read the same.
#pragma once

#include "schema/catalogue.hpp"
#include "validator/reading.hpp"

namespace axisc::tests {

/// Everything that either of two readings of one source tells.
[[nodiscard]] bool same_lists(validator::ReadList const& a, validator::ReadList const& b,
                              schema::Catalogue const& catalogue = {});

/// Read in every way that this processor can go; the others read by the grammar.
[[nodiscard]] bool reads_alike_in_all_ways(SourceText const& source, schema::Catalogue const& catalogue = {});

}  // namespace axisc::tests
