// Files that exist only in a map: what tests read instead of the disk.
#pragma once

#include "configuration/files.hpp"

#include <map>
#include <string>
#include <utility>
#include <variant>

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

  std::map<std::string, configuration::FileError> errors;  ///< files that cannot be read, and why
  std::map<std::string, int> reads;                        ///< how often each path was asked for

 private:
  std::map<std::string, std::string> contents_;
};

}  // namespace axisc::tests
