// What the command line needs from a machine file or a start-up list before the validator checks it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct MachineOutline {
  bool is_machine =
      false;  ///< a start-up list, a project, a JSON object with the key "axes", or something that tries to be one
  bool is_xml_list = false;  ///< an update or template file, or XML that may have been one
  bool is_unclear = false;   ///< JSON that is cut off or no text: it may have been a machine file
  // What it names, relative to its own folder.
  std::vector<std::string> lists = {};
  std::vector<std::string> programs = {};
  /// Of a start-up list: the lists that it names, found or not, as it writes them.
  std::vector<std::string> written = {};
};

[[nodiscard]] MachineOutline read_machine_outline(std::string_view json);

/// Of a file; empty for a list of another kind, and for JSON, XML and projects that say themselves that they are something
/// else. What is unreadable, UTF-16 or damaged counts as what it may have been, so that the check reports it. Cost: of a
/// list, its first 64 KiB are searched.
[[nodiscard]] MachineOutline outline_of(std::string const& path);

}  // namespace axisc
