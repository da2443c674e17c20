#include "axisc/files/repository.hpp"

namespace axisc {

std::optional<std::filesystem::path> repository_of(std::filesystem::path folder) {
  while (true) {
    std::error_code error;
    // A folder, or a file in the work trees and submodules of git.
    if (std::filesystem::exists(folder / ".git", error)) return folder;
    if (!folder.has_relative_path()) return std::nullopt;
    folder = folder.parent_path();
  }
}

}  // namespace axisc
