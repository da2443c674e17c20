// The command position of a path's axes before their filters, as a scope recorded it.
#pragma once

#include "analysis/motion/point.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axisc::comparison {

/// One axis; position units, a value a cycle.
struct RecordedPosition {
  std::size_t axis = 0;  ///< of the path
  std::vector<double> values;
  double resolution = 0;  ///< 0 where the numbers have more than six decimals
  double allowed = 0;     ///< largest deviation that rounding and the control's own arithmetic explain
};

/// With what is allowed: half of a step, and a little.
[[nodiscard]] RecordedPosition recorded_position(std::size_t axis, std::vector<double> values,
                                                 double resolution);

struct RecordedPath {
  std::vector<RecordedPosition> positions;  ///< at least one, all of the same length
  std::vector<char> is_gap = {};            ///< by cycle: not recorded, interpolated; empty where none is

  [[nodiscard]] std::size_t size() const { return positions.front().values.size(); }
  [[nodiscard]] bool counts(std::size_t cycle) const { return is_gap.empty() || is_gap[cycle] == 0; }
};

/// A part of a recording in which the path moves: `begin` is the last cycle at rest before it, `end` the
/// first one after it.
struct Stretch {
  std::size_t begin = 0, end = 0;
};

/// The axes rest for at least `rest` cycles between two of them. One may begin with the recording, or end
/// with it.
[[nodiscard]] std::vector<Stretch> moving_stretches(RecordedPath const& path, std::size_t rest);

/// How far a plan is from a recording, after the constant by which they differ. Position units, over all
/// axes.
struct Deviation {
  double largest = 0;  ///< half of the range of the differences
  double square_sum = 0;
  std::size_t count = 0;
  /// `largest` as a multiple of what rounding explains, of the axis with most of it: up to 1 it fits.
  double excess = 0;

  [[nodiscard]] bool fits() const { return excess <= 1; }
  [[nodiscard]] double rms() const;
  void add(Deviation const& other);
};

/// The deviation of a plan, a setpoint a cycle from rest to rest, at the whole-cycle offset that fits best.
/// Every offset is tried at which both begin to move within a step of the resolution; no other one can fit.
/// Where none of them does, the middles and the ends are brought together as well. `free` is the room: from
/// the end of the move before to the beginning of the next one.
[[nodiscard]] Deviation deviation_of(std::span<motion::Point const> plan, RecordedPath const& path,
                                     Stretch const& moving, Stretch const& free);

}  // namespace axisc::comparison
