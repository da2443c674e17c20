// Values and comments of a list in columns.
#pragma once

#include "diagnostics/source_text.hpp"
#include "schema/catalogue.hpp"

#include <string>

namespace axisc::validator {

/// The whole list, with the values of each paragraph in one column and the comments behind them in another. A paragraph
/// is a run of assignments that no blank line, comment line or line that stays as it is interrupts.
///
/// Only blanks and tabs between name, value and comment change, and those at the end of an assignment. What the list means, the
/// order, indentation, encoding, line ends and everything on other lines stay. A value whose end only the control knows (a
/// string with blanks, a symbol with text behind it) keeps all of its line up to the `(`. Lines that cannot be read, those
/// whose value cannot be read and is not parted from a `(`, and those of more than 1,024 bytes stay as they are. Applying it
/// twice changes nothing. Cost: two to three times that of reading the list.
[[nodiscard]] std::string aligned_list(SourceText const& source, schema::Catalogue const& catalogue = {});

}  // namespace axisc::validator
