#include "schema/ascii.hpp"

#include "support/catch.hpp"

#include <cstddef>
#include <string>

namespace {

using namespace axisc::schema;

TEST_CASE("every byte at every place of short texts is told to be a capital or not") {
  for (std::size_t size = 1; size <= 20; ++size) {
    for (std::size_t at = 0; at < size; ++at) {
      for (int byte = 0; byte < 256; ++byte) {
        std::string text(size, '_');
        text[at] = static_cast<char>(byte);
        if (at > 0) text[at - 1] = static_cast<char>(255 - byte);
        INFO(size << " " << at << " " << byte);
        REQUIRE(is_lower_case(text) == (lower_case(text) == text));
      }
    }
  }
  CHECK(is_lower_case(""));
}

}  // namespace
