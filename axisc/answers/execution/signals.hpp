// Test signals of `axisc run`, one value per NC cycle.
#pragma once

#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc {

/// With amplitude A, cycle n and t = n T:
///     step         x = A
///     ramp:RATE    x = A RATE t       (RATE in units per second)
///     sine:HZ      x = A sin(2 pi HZ t)
///     impulse      x = A in cycle 0, else 0
class Signal {
 public:
  enum class Shape : std::uint8_t { step, ramp, sine, impulse };

  /// "step", "ramp:UNITS_PER_S", "sine:HZ" or "impulse"; none for any other text.
  [[nodiscard]] static std::optional<Signal> parse(std::string_view text);

  /// Value in cycle `n`. Cost: constant, so that a signal of any length needs no memory.
  [[nodiscard]] double at(std::uint64_t n, double amplitude, design::CycleTime cycle_time) const;

 private:
  Signal(Shape shape, double rate) : shape_(shape), rate_(rate) {}

  Shape shape_;
  double rate_;  ///< units per second, or Hz
};

}  // namespace axisc
