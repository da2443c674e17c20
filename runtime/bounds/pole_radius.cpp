#include "runtime/bounds/pole_radius.hpp"

#include "runtime/bounds/exact_sign.hpp"
#include "runtime/bounds/outward.hpp"

namespace axisc::runtime::bounds {
namespace {

///     of_constant (1 - b) + of_radius (2 - k - b) R + R^2 >= 0
bool holds(double radius, double k, double b, double of_constant, double of_radius) {
  double const R = radius;
  double const m = of_radius;
  double const c = of_constant;
  // What rounding changes is far below 2^-48 of all terms together; only next to 0 it matters.
  double const rounded = R * R + c - c * b + 2 * m * R - m * k * R - m * b * R;
  double const terms = R * R + 1 + b + (2 + k + b) * R;
  if (magnitude(rounded) > 0x1p-48 * terms) return rounded > 0;
  ExactSum sum;
  sum.add_product(R, R);
  sum.add_product(c, 1);
  sum.add_product(-c, b);
  sum.add_product(2 * m, R);
  sum.add_product(-m * k, R);
  sum.add_product(-m * b, R);
  return !sum.is_negative();
}

}  // namespace

bool poles_are_within(double radius, double k, double b) {
  if (radius == 0) return k == 1 && b == 1;
  return holds(radius, k, b, 1, 0) && holds(radius, k, b, -1, 0) && holds(radius, k, b, 1, 1) &&
         holds(radius, k, b, 1, -1);
}

double smallest_radius(double k, double b) {
  if (poles_are_within(0, k, b)) return 0;
  // Positive doubles are ordered as their bits are. Products of numbers from 2^-200 on are exact.
  constexpr uint64_t step = dropped_bits + 1;
  uint64_t outside = std::bit_cast<uint64_t>(0x1p-200) / step;
  uint64_t within = std::bit_cast<uint64_t>(1.0) / step;
  while (within - outside > 1) {
    uint64_t const middle = outside + (within - outside) / 2;
    (poles_are_within(std::bit_cast<double>(middle * step), k, b) ? within : outside) = middle;
  }
  return std::bit_cast<double>(within * step);
}

}  // namespace axisc::runtime::bounds
