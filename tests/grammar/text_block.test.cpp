// The classes of bytes are the same with vectors and without.
#include "support/catch.hpp"

#include <string>

#if defined(__SSE2__)

#define AXISC_LEVEL by_table
#include "grammar/levels/table_block_def.hpp"
#undef AXISC_LEVEL
#define AXISC_LEVEL by_vector
#include "grammar/levels/text_block_def.hpp"
#undef AXISC_LEVEL

TEST_CASE("every byte is of the same class at every place of a block") {
  using namespace axisc::grammar;
  for (unsigned byte = 0; byte < 256; ++byte) {
    for (unsigned place = 0; place < 64; ++place) {
      std::string text(64, ',');
      text[place] = static_cast<char>(byte);
      by_table::TextBlock const plain(text.data());
      by_vector::TextBlock const wide(text.data());
      CAPTURE(byte, place);
      REQUIRE(plain.line_feed() == wide.line_feed());
      REQUIRE(plain.carriage_return() == wide.carriage_return());
      REQUIRE(plain.blank() == wide.blank());
      REQUIRE(plain.unusual() == wide.unusual());
    }
  }
}

#endif
