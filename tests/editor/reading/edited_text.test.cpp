// A text under many edits.
#include "editor/reading/edited_text.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <utility>

using namespace axisc;

TEST_CASE("a text with many edits counts lines as one that is read anew") {
  std::mt19937 random(20240229);
  auto const below = [&random](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  std::array<std::string, 7> const pieces = {"", "\n", "\r", "\r\n", "a", "x\ny\r", "\n\n\r\n"};
  constexpr auto encoding = editor::PositionEncoding::utf8;
  std::string text = "one\r\ntwo\n";
  editor::EditedText edited(text, encoding);
  for (int i = 0; i < 20'000; ++i) {
    auto const begin = below(text.size() + 1);
    auto const end = std::min(text.size(), begin + below(text.size() > 60 ? text.size() + 1 : 4));
    auto const& piece = pieces[below(pieces.size())];
    text.replace(begin, end - begin, piece);
    edited.replace(begin, end, piece);
    for (std::size_t line = 0; line < 12; ++line) {
      editor::TextPosition const position{.line = line, .character = below(5)};
      if (edited.offset(position) != editor::TextLines(text, encoding).offset(position))
        FAIL(i << " " << text);
    }
  }
  CHECK(std::move(edited).take() == text);
}
