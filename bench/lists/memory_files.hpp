// Files that are strings in memory.
#pragma once

#include "validator/files.hpp"

#include <map>
#include <string>

namespace axisc::bench {

class MemoryFiles final : public validator::Files {
 public:
  void put(std::string path, std::string content) { contents_.insert_or_assign(std::move(path), std::move(content)); }
  std::variant<std::string, validator::FileError> read(std::string const& path) override {
    auto const content = contents_.find(path);
    if (content == contents_.end()) return validator::FileError::not_found;
    return content->second;
  }

 private:
  std::map<std::string, std::string> contents_;
};

}  // namespace axisc::bench
