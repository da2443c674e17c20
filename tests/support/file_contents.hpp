// The bytes of a file.
#pragma once

#include "support/catch.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace axisc::test {

/// Block by block: byte by byte, what the longest tests read would take longer than to write it. A file that
/// cannot be read fails the test.
[[nodiscard]] inline std::string file_contents(std::filesystem::path const& path) {
  std::ifstream const file(path, std::ios::binary);
  INFO("reading " << path);
  REQUIRE(file.good());
  std::ostringstream contents;
  contents << file.rdbuf();
  return std::move(contents).str();
}

}  // namespace axisc::test
