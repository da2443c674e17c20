// Values and comments of a list in columns.
#pragma once

#include "diagnostics/source_text.hpp"
#include "schema/catalogue.hpp"

#include <string>

namespace axisc::validator {

/// The whole list, with the values of each paragraph in one column and the comments behind them in another. A paragraph
/// is a run of assignments that no blank line, comment line or broken line interrupts.
///
/// Only blanks and tabs between name, value and comment change, and those at the end of an assignment. What a
/// name, a value or a comment says, the order, indentation, encoding, line ends and everything on other lines stay. A
/// value whose end only the control knows (a string with blanks, a symbol with text behind it) keeps all of its line
/// up to the `(`. Applying it twice changes nothing. Cost: as reading the list.
[[nodiscard]] std::string aligned_list(SourceText const& source, schema::Catalogue const& catalogue = {});

}  // namespace axisc::validator
