// Cuts a motion into parts of given lengths.
#pragma once

#include "analysis/motion/phase.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::motion {

class PhaseCutter {
 public:
  /// The phases must outlive this.
  explicit PhaseCutter(std::span<Phase const> phases) : phases_(phases) {}

  /// Appends the phases along the next `length`, or all that are left.
  void cut(double length, std::vector<Phase>& parts);
  /// Where the last part ends.
  [[nodiscard]] double velocity() const;
  [[nodiscard]] bool is_steady() const { return at_ < phases_.size() && phases_[at_].is_steady(); }

 private:
  std::span<Phase const> phases_;
  std::size_t at_ = 0;
  double time_ = 0;  ///< since the beginning of the phase
  double way_ = 0;
};

/// The part of a phase between two times.
[[nodiscard]] Phase part_of(Phase const& phase, double from, double to);
/// When a phase has come so far.
[[nodiscard]] double time_at(Phase const& phase, double way);

}  // namespace axisc::motion
