// The repository that a folder belongs to.
#pragma once

#include <filesystem>
#include <optional>

namespace axisc {

/// The nearest folder with .git among `folder`, an absolute path, and those above it.
[[nodiscard]] std::optional<std::filesystem::path> repository_of(std::filesystem::path folder);

}  // namespace axisc
