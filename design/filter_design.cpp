#include "design/filter_design.hpp"

#include "design/filter_design_instances.hpp"

#include <cmath>

namespace axisc::design {

FilterDesign design_filter(FilterSpecification const& specification, CycleTime cycle_time,
                           Precision precision) {
  CycleTime const computed_for = as_read(cycle_time, specification.cycle_time);
  return precision == Precision::quick ? design_quick(specification, computed_for)
                                       : design_exact(specification, computed_for);
}

FilterDesign design_oscillator(OscillatorSpecification const& specification, CycleTime cycle_time,
                               Precision precision) {
  return precision == Precision::quick ? design_quick(specification, cycle_time)
                                       : design_exact(specification, cycle_time);
}

bool is_loadable(IncrementSection const& section) {
  constexpr double largest_numerator = 64;
  auto const [p, q, k, b] = section;
  bool const is_stable = k > 0 && b > 0 && b < 2 && 4 - k - 2 * b > 0;
  return is_stable && std::abs(p) <= largest_numerator && std::abs(q) <= largest_numerator;
}

double rounding_error(FilterDesign const& filter) {
  constexpr double rounding_of_a_section = 0x1p-49;  // k up to 4, b up to 2, and as much in the numerator
  double error = 0;
  for (IncrementSection const& section : filter.sections) {
    if (!is_loadable(section)) return HUGE_VAL;
    error += rounding_of_a_section / (4 - section.k - 2 * section.b);
  }
  return error * filter.share.filtered;
}

DirectSection direct_form(IncrementSection const& section, bool blocks_constant) {
  auto const [p, q, k, b] = section;
  double const a1 = k + b - 2;
  double const a2 = 1 - b;
  // H = (p + q z^-1)(1 - z^-1)/A, and A/A more where H(1) = 1
  if (blocks_constant) return {.b0 = p, .b1 = q - p, .b2 = -q, .a1 = a1, .a2 = a2};
  return {.b0 = 1 + p, .b1 = a1 + (q - p), .b2 = a2 - q, .a1 = a1, .a2 = a2};
}

std::pair<std::complex<double>, std::complex<double>> poles(IncrementSection const& section) {
  // In v = z - 1: v² + (k + b) v + k = 0
  double const half = (section.k + section.b) / 2;
  double const discriminant = half * half - section.k;
  if (discriminant < 0) {
    double const im = std::sqrt(-discriminant);
    return {{1 - half, im}, {1 - half, -im}};
  }
  double const far = -(half + std::sqrt(discriminant));
  double const near = far == 0 ? 0.0 : section.k / far;
  return {{1 + near, 0}, {1 + far, 0}};
}

}  // namespace axisc::design
