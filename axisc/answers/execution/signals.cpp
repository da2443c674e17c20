#include "axisc/answers/execution/signals.hpp"

#include "axisc/asked/quantities.hpp"

#include <cmath>
#include <numbers>

namespace axisc {

std::optional<Signal> Signal::parse(std::string_view text) {
  if (text == "step") return Signal(Shape::step, 0);
  if (text == "impulse") return Signal(Shape::impulse, 0);
  auto const colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  auto const rate = parse_finite(text.substr(colon + 1));
  if (!rate) return std::nullopt;
  auto const name = text.substr(0, colon);
  if (name == "ramp") return Signal(Shape::ramp, *rate);
  if (name == "sine") return Signal(Shape::sine, *rate);
  return std::nullopt;
}

double Signal::at(std::uint64_t n, double amplitude, design::CycleTime cycle_time) const {
  double const t = static_cast<double>(n) * cycle_time.nanoseconds / 1e9;
  switch (shape_) {
    case Shape::step: return amplitude;
    case Shape::ramp: return amplitude * (rate_ * t);
    case Shape::sine: return amplitude * std::sin(2 * std::numbers::pi * std::fmod(rate_ * t, 1.0));
    case Shape::impulse: return n == 0 ? amplitude : 0.0;
  }
  return 0;
}

}  // namespace axisc
