// Records the files that machines looked for, to find the machines that a changed file concerns.
#pragma once

#include <map>
#include <set>
#include <string>

namespace axisc {

/// The files that one machine was read from, and those it missed. Files count by the last part of their path,
/// whatever links lead to them.
struct AskedFiles {
  std::set<std::string> names;
  std::set<std::string> folders;  ///< that were listed, with `/` at the end

  void add(std::string const& path);
  void add_folder(std::string const& path);
};

/// The asked files of all machines that were read.
class Readers {
 public:
  void add(std::string const& machine, AskedFiles const& asked);
  void clear();
  /// A machine other than the file itself looked for the file, or may have.
  [[nodiscard]] bool know(std::string const& path) const;

 private:
  using Machines = std::set<std::string>;
  std::map<std::string, Machines> names_;
  std::map<std::string, Machines> folders_;
};

}  // namespace axisc
