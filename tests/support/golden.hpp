// Golden files: the expected text of a test stands in the repository. With AXISC_UPDATE_GOLDEN=1 in the
// environment the tests write the files instead of comparing; the review then happens in the difference that
// version control shows.
#pragma once

#include <string>
#include <string_view>

namespace axisc::test {

[[nodiscard]] bool update_golden();

/// The bytes of a file of the source tree; fails the test when it cannot be read.
[[nodiscard]] std::string read_source_file(std::string const& path_in_source_tree);

/// Compares `actual` byte by byte with a file of the source tree.
void check_golden(std::string const& path_in_source_tree, std::string_view actual);

}  // namespace axisc::test
