// Reads an axis list: what is written, and what it means.
#pragma once

#include "validator/values/line_values.hpp"

namespace axisc::validator {

/// A list as it is written, and what each of its assignments means. The readings look into the tree: it may be moved, and
/// a copy of it is no substitute.
struct ReadList {
  grammar::AxisList tree;
  LineValues line_values;
};

/// Reads a list. Lines that give a parameter of the catalogue a plain value, or another one that looks simple, are read without
/// the grammar; the result is that of judge_list(). Cost: one look-up and one conversion per line; suggestions are made for
/// the first thousand unknown names only.
[[nodiscard]] ReadList read_list(SourceText const& source, schema::Catalogue const& catalogue = {});

/// What the assignments of a list mean that grammar::parse_axis_list() has read. Cost: twice to three times that of read_list(), together.
[[nodiscard]] ReadList judge_list(SourceText const& source, grammar::AxisList tree,
                                  schema::Catalogue const& catalogue = {});

}  // namespace axisc::validator
