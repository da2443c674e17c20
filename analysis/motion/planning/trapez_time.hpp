// How long a path takes with TRAPEZ in the place of HSC: how HSC is planned is a reading, and this is its
// measure.
#pragma once

#include "analysis/motion/look_ahead.hpp"

namespace axisc::motion {

class TrapezTime final : private PathSink {
 public:
  /// As those of the path, but for the reading of HSC.
  explicit TrapezTime(PathLimits const& limits);

  void begin(Point const& position, double acceleration_factor);
  void add(ProgrammedBlock const& block);
  void stop() { planner_.stop(); }
  /// Of all blocks since begin(); none where no block had the slope HSC.
  [[nodiscard]] std::optional<double> cycles() const;

 private:
  void piece(PathBlock const& block, Phase const& phase) override;
  void block_end(PathBlock const& /*block*/, PathBlock const* /*next*/,
                 BlockMotion const& /*motion*/) override {}
  void rest(PathBlock const& /*block*/, std::uint64_t /*cycles*/) override {}
  void exact_stop(PathBlock const& /*block*/) override {}
  [[nodiscard]] double room() const override { return std::numeric_limits<double>::infinity(); }

  LookAhead planner_;
  double cycles_ = 0;
  bool has_hsc_ = false;
};

}  // namespace axisc::motion
