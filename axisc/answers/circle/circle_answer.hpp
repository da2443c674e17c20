// The circular test as an answer: figures, causes and what to do about them.
#pragma once

#include "axisc/answers/circle/circular_test.hpp"
#include "presentation/document.hpp"

#include <string>
#include <vector>

namespace axisc {

/// One of the reasons why a circle is not round.
struct CircleCause {
  presentation::Words name;
  double size_um = 0;  ///< what it adds to G, of the radius to D
  std::optional<presentation::Words> remedy;
};

/// Of the recording, or of the prediction without one; the largest first. What cannot be told apart is left
/// out.
[[nodiscard]] std::vector<CircleCause> causes_by_size(CircleCase const& one);

/// Figures, causes and remedies of one circle, without a title.
[[nodiscard]] std::vector<presentation::Block> circle_blocks(CircularTest const& test, CircleCase const& one);

/// "X/Y, r 50 mm, 4000 mm/min".
[[nodiscard]] presentation::Words circle_title(CircleCase const& one);

[[nodiscard]] presentation::Document circle_answer(CircularTest const& test);

}  // namespace axisc
