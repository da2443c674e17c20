#include "diagnostics/terminal.hpp"

#include "support/catch.hpp"

#include <string>

using namespace axisc;
using namespace std::string_literals;

TEST_CASE("text for a terminal holds nothing that steers it") {
  CHECK(printable("12 µs €😀") == "12 µs €😀");
  CHECK(printable("a\x1b[31mb\n\t\r\x7f"s) == "a␛[31mb␊␉␍␡");
  CHECK(printable("\0"s) == "␀");
  CHECK(printable("\xC2\x9B") == "\xEF\xBF\xBD");
  CHECK(printable("\xFF") == "\xEF\xBF\xBD");
  CHECK(printable("\xE2\x80\xAE\xE2\x80\xAC") == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(printable("\xE2\x80\xA8") == "\xEF\xBF\xBD");
}

TEST_CASE("what a reader would not see is not visible") {
  // A separator, joiners and spaces without width, marks of direction, a byte order mark, a tag, a soft
  // hyphen.
  for (auto const* const hidden : {"\x1b", "\n", "\x7f", "\u0085", "\u200b", "\u200d", "\u2060", "\u2028",
                                   "\u202e\u202c", "\u2066\u2069", "\ufeff", "\U000e0041", "\u00ad"}) {
    std::string const text = "a"s + hidden + "b";
    CHECK_FALSE(is_visible(text));
    CHECK(is_visible(printable(text)));
    CHECK(printable(text).size() > 2);
  }
  CHECK(is_visible("Fräse 3 µ €😀"));
  CHECK(is_visible(""));
}

TEST_CASE("colours are put around words only where they are wanted") {
  CHECK(Painter(false)(Style::error, "x") == "x");
  CHECK(Painter(true)(Style::error, "x") == "\x1b[1;31mx\x1b[0m");
  CHECK(Painter(true)(Style::warning, "x") == "\x1b[1;33mx\x1b[0m");
  CHECK(Painter(true)(Style::note, "").empty());
}

TEST_CASE("text is plain where each of its characters is, wherever another one stands") {
  for (int byte = 0; byte < 256; ++byte) {
    for (std::size_t before = 0; before < 20; ++before) {
      std::string const text = std::string(before, 'a') + static_cast<char>(byte) + "~ b";
      CHECK(is_plain(text) == is_plain(static_cast<char>(byte)));
    }
  }
  CHECK(is_plain(""));
}
