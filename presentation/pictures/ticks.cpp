#include "presentation/pictures/ticks.hpp"

#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::pictures {
namespace {

/// Of 1, 2 and 5 times a power of ten the largest with which at least `wanted` steps fit into `span`.
double round_step(double span, std::size_t wanted) {
  return round_below(span / static_cast<double>(std::max<std::size_t>(wanted, 1)));
}

std::vector<double> linear_ticks(Axis const& axis, std::size_t wanted) {
  double const step = round_step(axis.high - axis.low, wanted);
  // A limit that is a multiple itself must not be lost to rounding.
  constexpr double slack = 1e-9;
  std::vector<double> ticks;
  for (double n = std::ceil(axis.low / step - slack); n * step <= axis.high + slack * step; ++n) {
    ticks.push_back(n * step);
  }
  return ticks;
}

std::vector<double> logarithmic_ticks(Axis const& axis, std::size_t wanted) {
  double const decades = std::log10(axis.high / axis.low);
  bool const has_room = decades * 3 <= static_cast<double>(wanted);
  std::vector<double> ticks;
  auto const last = static_cast<int>(std::floor(std::log10(axis.high)));
  for (auto exponent = static_cast<int>(std::floor(std::log10(axis.low))); exponent <= last; ++exponent) {
    for (double const factor : {1.0, 2.0, 5.0}) {
      if (factor != 1.0 && !has_room) continue;
      double const tick = factor * std::pow(10.0, static_cast<double>(exponent));
      if (tick >= axis.low && tick <= axis.high) ticks.push_back(tick);
    }
  }
  return ticks;
}

}  // namespace

double round_below(double value) {
  double const power = std::pow(10.0, std::floor(std::log10(value)));
  for (double const factor : {5.0, 2.0}) {
    if (factor * power <= value) return factor * power;
  }
  return power;
}

std::vector<double> ticks_of(Axis const& axis, std::size_t wanted) {
  if (!axis.ticks.empty()) return axis.ticks;
  return axis.scale == Scale::linear ? linear_ticks(axis, wanted) : logarithmic_ticks(axis, wanted);
}

std::string number_text(double value, Language language) {
  constexpr int digits = 6;
  std::string text = format_rounded(value, digits).in(language);
  std::size_t const point = std::min(text.find_first_of(".,e"), text.size());
  std::size_t const first = text.starts_with('-') ? 1 : 0;
  // Four digits are read without help.
  constexpr std::size_t group = 3;
  constexpr std::string_view narrow_space = "\u202F";
  if (point - first > group + 1) {
    for (std::size_t at = point - group; at > first && at < point; at -= std::min(at, group)) {
      text.insert(at, narrow_space);
    }
  }
  return text;
}

}  // namespace axisc::pictures
