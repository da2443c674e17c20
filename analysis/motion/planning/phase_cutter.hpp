// Cuts a motion into parts of given lengths.
#pragma once

#include "analysis/motion/planning/phase.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::motion {

class PhaseCutter {
 public:
  /// The phases must outlive this.
  explicit PhaseCutter(std::span<Phase const> phases) : phases_(phases) {}

  /// Goes on by `length`, or to the end. Appends the phases of this part where `parts` is not null.
  void advance(double length, std::vector<Phase>* parts = nullptr);
  /// Where the last part ends.
  [[nodiscard]] double velocity() const;
  /// The highest of the last part.
  [[nodiscard]] double highest() const { return highest_; }
  [[nodiscard]] bool is_steady() const { return at_ < phases_.size() && phases_[at_].is_steady(); }

 private:
  std::span<Phase const> phases_;
  std::size_t at_ = 0;
  double time_ = 0;  ///< since the beginning of the phase
  double way_ = 0;
  double highest_ = 0;
};

/// The part of a phase between two times.
[[nodiscard]] Phase part_of(Phase const& phase, double from, double to);
/// When a phase has come so far, by Newton's method from a time near it.
[[nodiscard]] double time_at(Phase const& phase, double way, double near);

}  // namespace axisc::motion
