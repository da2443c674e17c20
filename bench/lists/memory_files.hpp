// Files that are texts in memory, of which a reader gets a copy, as from a disk.
#pragma once

#include "configuration/files.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace axisc::bench {

class MemoryFiles final : public configuration::Files {
 public:
  /// `content` lives longer than this.
  void put(std::string path, std::string_view content) {
    contents_.insert_or_assign(std::move(path), content);
  }
  std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    auto const content = contents_.find(path);
    if (content == contents_.end()) return configuration::FileError::not_found;
    return std::string(content->second);
  }

 private:
  std::map<std::string, std::string_view> contents_;
};

}  // namespace axisc::bench
