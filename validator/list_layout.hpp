// Values and comments of a list in columns.
#pragma once

#include "diagnostics/source_text.hpp"
#include "schema/catalogue.hpp"

#include <cstdint>
#include <string>

namespace axisc::validator {

enum class AlignedKinds : std::uint8_t {
  all,              ///< a list of unknown kind is taken for an axis list
  axis_or_unknown,  ///< only axis lists, and lists of unknown kind; all others are unchanged
  axis,             ///< only lists that are known to be axis lists by their content
};

/// The whole list, with the values of each paragraph in one column and the comments after them in another. A
/// paragraph is a run of assignments without a blank line, comment line or unchanged line in between. A list
/// of a dozen lines or more of which three in four have their values in one column keeps this column, and
/// likewise that of its comments.
///
/// Only blanks and tabs between name, value and comment change, and those at the end of an assignment. The
/// meaning of the list, its order, indentation, encoding, line ends and all other lines are preserved. A
/// value whose end only the control knows (a string with blanks, a symbol with text after it) keeps all of
/// its line up to the `(`. Unchanged are lines that cannot be read, lines whose value cannot be read and is
/// not separated from a `(`, and lines of more than 1,024 bytes. Applying it twice changes nothing. Cost: up
/// to six times that of reading the list.
[[nodiscard]] std::string aligned_list(SourceText const& source, schema::Catalogue const& catalogue = {},
                                       AlignedKinds kinds = AlignedKinds::all);

}  // namespace axisc::validator
