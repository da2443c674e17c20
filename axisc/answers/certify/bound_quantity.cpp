#include "axisc/answers/certify/bound_quantity.hpp"

#include <cmath>

namespace axisc {
namespace {

using namespace presentation;

/// Stored bounds are rounded outwards to 40 bits.
constexpr double of_storing = 4e-12;

double last_digit(double value, int digits) {
  return std::pow(10, std::floor(std::log10(value)) - digits + 1);
}

}  // namespace

Quantity upper_bound(double value, int digits, Unit unit) {
  if (!(value > 0)) return rounded(value, unit, digits);
  double const step = last_digit(value, digits);
  return rounded(std::ceil(value / step * (1 - of_storing)) * step, unit, digits);
}

Quantity lower_bound(double value, int digits) {
  if (!(value > 0)) return rounded(value, Unit::none, digits);
  double const step = last_digit(value, digits);
  return rounded(std::floor(value / step * (1 + of_storing)) * step, Unit::none, digits);
}

}  // namespace axisc
