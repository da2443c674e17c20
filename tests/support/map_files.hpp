// Files that exist only in a map: what tests read instead of the disk.
#pragma once

#include "configuration/files.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::tests {

class MapFiles final : public configuration::Files {
 public:
  explicit MapFiles(std::map<std::string, std::string> contents) : contents_(std::move(contents)) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    ++reads[path];
    auto const error = errors.find(path);
    if (error != errors.end()) return error->second;
    auto const content = contents_.find(path);
    if (content == contents_.end()) return configuration::FileError::not_found;
    return content->second;
  }

  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override {
    std::string_view const within = std::string_view(folder).substr(folder.starts_with("./") ? 2 : 0);
    std::vector<std::string> names;
    for (auto const& [path, content] : contents_) {
      std::string_view const name = std::string_view(path).substr(std::min(within.size(), path.size()));
      bool const is_inside = path.starts_with(within) && name.find('/') == std::string_view::npos;
      if (is_inside && !name.empty()) names.emplace_back(name);
    }
    return names;
  }

  std::map<std::string, configuration::FileError> errors;  ///< files that cannot be read, and why
  std::map<std::string, int> reads;                        ///< how often each path was asked for

 private:
  std::map<std::string, std::string> contents_;
};

}  // namespace axisc::tests
