// Circles as programs write them: G02 and G03 with I, J, K or R in the plane of G17, G18 or G19.
#pragma once

#include "analysis/motion/segment.hpp"
#include "diagnostics/sentence.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace axisc::motion {

/// A circle as a block gives it; position units.
struct ArcWords {
  std::size_t first = 0, second = 1;  ///< axes of the plane
  bool clockwise = false;
  /// From the beginning to the centre, I, J, K of the plane's axes.
  std::optional<double> to_center_first, to_center_second;
  std::optional<double> radius;  ///< below 0: the longer of two arcs
};

enum class ArcMistake : std::uint8_t {
  no_center,       ///< neither I, J, K nor R
  both,            ///< I, J, K and R
  no_radius,       ///< the centre is the beginning
  too_small,       ///< twice the radius does not reach the end
  full_by_radius,  ///< R does not determine where a full circle lies
  misses_end,      ///< the end lies off the circle about the centre
};

[[nodiscard]] SentenceRef sentence_of(ArcMistake mistake);

/// The end may miss the circle by this much, as rounded programs do: position units, 5 µm. The centre is then
/// moved to where both are equally far away.
inline constexpr double radius_tolerance = 50;

/// An end that is the beginning in the plane means a full circle.
[[nodiscard]] std::variant<Arc, ArcMistake> arc_of(ArcWords const& words, Point const& begin,
                                                   Point const& end);

}  // namespace axisc::motion
