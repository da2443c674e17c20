// A folder for files that other programs read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace axisc {

/// In the system's folder for temporary files, with a name that no other process has; removed at the end.
class TemporaryFolder {
 public:
  /// Failure (AX9002) where it cannot be made.
  TemporaryFolder();
  TemporaryFolder(TemporaryFolder const&) = delete;
  TemporaryFolder& operator=(TemporaryFolder const&) = delete;
  ~TemporaryFolder();

  /// A path in it.
  [[nodiscard]] std::string operator/(std::string_view name) const;
  /// Failure (AX9002) where it cannot be written.
  void write(std::string_view name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace axisc
