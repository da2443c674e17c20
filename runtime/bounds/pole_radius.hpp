// B1: no pole of a section is farther from 0 than a radius.
#pragma once

namespace axisc::runtime::bounds {

/// Poles of A(z) = z^2 - (2 - k - b) z + (1 - b) are within the radius R > 0 exactly where (Jury)
///     |1 - b| <= R^2,   |2 - k - b| R <= R^2 + 1 - b,
/// which is decided without rounding. Expects k > 0, 0 < b < 2, 4 - k - 2b > 0.
[[nodiscard]] bool poles_are_within(double radius, double k, double b);

/// The smallest radius of 40 bits; 0 where both poles are 0, at most 1.
[[nodiscard]] double smallest_radius(double k, double b);

}  // namespace axisc::runtime::bounds
