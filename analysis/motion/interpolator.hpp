// Samples a planned path once per NC cycle.
#pragma once

#include "analysis/motion/look_ahead.hpp"

#include <cstdint>
#include <limits>

namespace axisc::motion {

/// Receives the setpoint of each cycle, and the corners that the path passes in between.
class SampleSink {
 public:
  virtual ~SampleSink() = default;
  /// At most this many more cycles are followed.
  [[nodiscard]] virtual double room() const { return std::numeric_limits<double>::infinity(); }
  /// A piece of a block would take longer than that: none of it is sampled.
  virtual void no_room(PathBlock const& /*block*/) {}
  /// A setpoint; `velocity` is the path's, in units per cycle.
  virtual void sample(Point const& setpoint, double velocity, PathBlock const& block) = 0;
  /// A phase of a block, before its setpoints.
  virtual void phase(PathBlock const& /*block*/, Phase const& /*phase*/) {}
  /// The end of a block, which need not be on a cycle, and its duration in cycles. `next` is null where the
  /// path stops.
  virtual void corner(PathBlock const& block, PathBlock const* next, double block_cycles,
                      BlockMotion const& motion) = 0;
  /// The path stopped at the end of a block, and waits until the axes are there.
  virtual void exact_stop(PathBlock const& /*block*/) {}

 protected:
  SampleSink() = default;
  SampleSink(SampleSink const&) = default;
  SampleSink& operator=(SampleSink const&) = default;
};

/// The path begins on a cycle whose setpoint has been given already. Where it stops, the first cycle after
/// the stop gives the end point.
class Interpolator final : public PathSink {
 public:
  explicit Interpolator(SampleSink& sink) : sink_(sink) {}

  void piece(PathBlock const& block, Phase const& phase) override;
  void block_end(PathBlock const& block, PathBlock const* next, BlockMotion const& motion) override;
  void rest(PathBlock const& block, std::uint64_t cycles) override;
  void exact_stop(PathBlock const& block) override { sink_.exact_stop(block); }
  [[nodiscard]] double room() const override { return sink_.room(); }

 private:
  SampleSink& sink_;
  double to_sample_ = 1;     ///< cycles from the beginning of the next piece to the next sample
  double passed_ = 0;        ///< of the block, units
  double velocity_ = 0;      ///< after the last piece
  double block_cycles_ = 0;  ///< of the block so far
};

}  // namespace axisc::motion
