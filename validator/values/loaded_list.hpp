// A list in memory.
#pragma once

#include "validator/values/lost_assignment.hpp"

#include <vector>

namespace axisc::validator {

/// A list that was read: its source, its tree, its role, and what each assignment means.
struct LoadedList {
  SourceId source{};
  schema::Catalogue catalogue;
  grammar::AxisList tree;
  bool is_default_list = false;
  Readings readings;  ///< one per assignment of the tree
  std::vector<LostAssignment> lost;
};

}  // namespace axisc::validator
