// A TwinCAT 3 project or one of its parts (*.tsproj, *.xti): the lists of a machine as texts in one XML file.
#pragma once

#include "configuration/list_kind.hpp"
#include "configuration/listed_values.hpp"
#include "configuration/real_time_list.hpp"
#include "diagnostics/finding.hpp"

#include <deque>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::configuration {

/// An axis or channel object: its list, and the values next to it.
struct ProjectList {
  ListKind kind = ListKind::axis;            ///< that belongs in the element: axis in AchsMds
  Span span;                                 ///< of the list's text in the file
  LocatedText name;                          ///< ItemName; without one, that of the element
  std::optional<LocatedText> program_name;   ///< DefaultProgName: what programs call the axis
  std::optional<ListCount> default_channel;  ///< DefaultChannel, counted from 1
  std::optional<ListCount> default_index;    ///< DefaultIndex: the place of the axis in that channel
};

struct Project {
  std::vector<ProjectList> lists;  ///< in the order of the file
  RealTimeList real_time;          ///< CycleTime of the task
  Encoding encoding = Encoding::utf8;
  bool is_of_cnc =
      true;  ///< false for well-formed XML without an element for the list of an axis or a channel
};

/// Reads `sources[source]`; mistakes become AX4020 findings (place and sentences), and values with mistakes
/// are left out.
[[nodiscard]] Project read_project(SourceSet const& sources, SourceId source, std::deque<Finding>& findings);

/// True for a name that ends in .tsproj or .xti.
[[nodiscard]] bool is_project_name(std::string_view path);

}  // namespace axisc::configuration
