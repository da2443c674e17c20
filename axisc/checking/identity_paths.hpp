// Files as identities of findings name them, so that a baseline fits every checkout: relative to the
// repository (the nearest folder with .git), else to the folder of the settings, else to the working folder.
#pragma once

#include "axisc/settings/settings.hpp"

#include <map>
#include <optional>
#include <string>

namespace axisc {

class IdentityPaths {
 public:
  explicit IdentityPaths(SettingsFinder& settings);

  /// "-" and files outside of these folders keep their names. Cost: system calls once per folder and file.
  [[nodiscard]] std::string const& of(std::string const& file);
  /// True if there is no such file below the working folder's repository (or the folder used instead of it).
  /// `path` is a name that of() gives.
  [[nodiscard]] bool is_gone(std::string const& path);

 private:
  [[nodiscard]] std::string path_of(std::string const& file);
  [[nodiscard]] std::string root_of(std::string const& file);

  SettingsFinder& settings_;
  std::string working_folder_;
  std::string root_;  ///< of the working folder
  std::map<std::string, std::string> paths_;
  std::map<std::string, bool> gone_;
  std::map<std::string, std::string> roots_;  ///< by folder
};

}  // namespace axisc
