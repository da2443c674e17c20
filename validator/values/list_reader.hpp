// Reads an axis list: its syntax and its meaning.
#pragma once

#include "validator/values/line_values.hpp"

namespace axisc::validator {

/// A list as it is written, and the meaning of each of its assignments. The line values look into the tree:
/// it may be moved, but not replaced by a copy.
struct ReadList {
  grammar::AxisList tree;
  LineValues line_values;
};

/// Reads a list. Lines that give a parameter of the catalogue a plain value, or another one that looks
/// simple, are read without the grammar; the result is that of judge_list(). Cost: one look-up and one
/// conversion per line; suggestions are made for the first thousand unknown names only.
[[nodiscard]] ReadList read_list(SourceText const& source, schema::Catalogue const& catalogue = {});

/// Judges the assignments of a list that grammar::parse_axis_list() has read. Cost: twice to three times that
/// of read_list(), together.
[[nodiscard]] ReadList judge_list(SourceText const& source, grammar::AxisList tree,
                                  schema::Catalogue const& catalogue = {});

}  // namespace axisc::validator
