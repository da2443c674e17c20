// How high text and tables become on paper, without a browser at hand: an upper estimate, laid out as
// browsers do, in the widest of the usual fonts.
#pragma once

#include "presentation/document.hpp"

#include <string_view>

namespace axisc {

/// Of the report's style for paper, all in points.
struct PrintedText {
  double size = 10;
  double line = 15;    ///< from one line to the next
  double width = 510;  ///< of A4 without its margins
  bool is_bold = false;
  double second_column = 0;  ///< of a table, at least
};

/// Wrapped at its spaces.
[[nodiscard]] double printed_height(std::string_view text, PrintedText const& style);

/// With its headings and the line that counts the rows not shown.
[[nodiscard]] double printed_height(presentation::Table const& table, Language language,
                                    PrintedText const& style);

/// Each field a row.
[[nodiscard]] double printed_height(presentation::Facts const& facts, Language language,
                                    PrintedText const& style);

}  // namespace axisc
