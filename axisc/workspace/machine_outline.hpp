// The facts about a machine file or a start-up list that are needed before the validator checks it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct MachineOutline {
  /// A start-up list, a project, a JSON object with the key "axes", or something that tries to be one.
  bool is_machine = false;
  bool is_xml_list = false;  ///< an update or template file, or XML that may have been one
  bool is_unclear = false;   ///< JSON that is cut off, or not text: it may have been a machine file
  // Files that it names, relative to its own folder.
  std::vector<std::string> lists = {};
  std::vector<std::string> programs = {};
  /// The lists that a start-up list names, found or not, as it writes them.
  std::vector<std::string> written = {};
};

[[nodiscard]] MachineOutline read_machine_outline(std::string_view json);

/// The outline of a file; empty for lists of other kinds, and for JSON, XML and projects that are
/// recognisably something else. Unreadable, UTF-16 and damaged files count as what they may have been, so
/// that the check reports them. Cost: searches the first 64 KiB of a list.
[[nodiscard]] MachineOutline outline_of(std::string const& path);

}  // namespace axisc
