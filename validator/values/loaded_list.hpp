// A list in memory.
#pragma once

#include "configuration/list_kind.hpp"
#include "validator/values/lost_assignment.hpp"

#include <vector>

namespace axisc::validator {

/// A list that was read: its source, its tree, its role, and the meaning of each assignment. A list of
/// another kind where an axis list is expected has an empty tree: its lines mean nothing to an axis.
struct LoadedList {
  SourceId source{};
  configuration::ListKind kind = configuration::ListKind::axis;
  schema::Catalogue catalogue;
  grammar::AxisList tree;
  bool is_default_list = false;
  LineValues line_values;  ///< one per assignment of the tree
  std::vector<LostAssignment> lost;
};

}  // namespace axisc::validator
