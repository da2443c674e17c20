#include "support/golden.hpp"

#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace axisc::test {

bool update_golden() {
  char const* const value = std::getenv("AXISC_UPDATE_GOLDEN");  // NOLINT(concurrency-mt-unsafe)
  return value != nullptr && std::string_view(value) == "1";
}

std::string read_source_file(std::string const& path_in_source_tree) {
  return file_contents(std::filesystem::path(AXISC_SOURCE_DIR) / path_in_source_tree);
}

void check_golden(std::string const& path_in_source_tree, std::string_view actual) {
  std::filesystem::path const path = std::filesystem::path(AXISC_SOURCE_DIR) / path_in_source_tree;
  if (update_golden()) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(actual.data(), static_cast<std::streamsize>(actual.size()));
    REQUIRE(file.good());
    return;
  }
  if (!std::filesystem::exists(path)) {
    FAIL("no golden file " << path_in_source_tree << "; AXISC_UPDATE_GOLDEN=1 writes it. Actual text:\n"
                           << actual);
  }
  std::string const expected = read_source_file(path_in_source_tree);
  INFO("golden file " << path_in_source_tree << "; AXISC_UPDATE_GOLDEN=1 rewrites it");
  CHECK(std::string(actual) == expected);
}

}  // namespace axisc::test
