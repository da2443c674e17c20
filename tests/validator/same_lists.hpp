// Whether two lists were read the same.
#pragma once

#include "schema/catalogue.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

namespace axisc::tests {

/// Everything that either of two readings of one source tells.
[[nodiscard]] bool same_lists(validator::ReadList const& a, validator::ReadList const& b,
                              schema::Catalogue const& catalogue = {});

/// The quick reader says of every line what the grammar and the closer look say.
[[nodiscard]] bool reads_as_by_the_grammar(SourceText const& source, schema::Catalogue const& catalogue = {});

}  // namespace axisc::tests
