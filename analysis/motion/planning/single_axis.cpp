#include "analysis/motion/planning/single_axis.hpp"

#include "analysis/motion/look_ahead.hpp"

#include <limits>

namespace axisc::motion {
namespace {

class PhaseCollector final : public PathSink {
 public:
  void piece(PathBlock const& /*block*/, Phase const& phase) override { phases.push_back(phase); }
  void block_end(PathBlock const& /*block*/, PathBlock const* /*next*/,
                 BlockMotion const& /*motion*/) override {}
  void rest(PathBlock const& /*block*/, std::uint64_t /*cycles*/) override {}
  void exact_stop(PathBlock const& /*block*/) override {}
  [[nodiscard]] double room() const override { return std::numeric_limits<double>::infinity(); }

  std::vector<Phase> phases;
};

}  // namespace

std::vector<Phase> phases_of(PathDynamics const& axis, SingleMove const& move) {
  PhaseCollector collector;
  LookAhead look_ahead(PathLimits(axis), false, collector);
  look_ahead.begin({}, {}, 1);
  ProgrammedBlock block;
  block.end[0] = move.length;
  if (!move.rapid) block.feed = move.feed;
  block.rapid = move.rapid;
  look_ahead.add(block);
  look_ahead.stop();
  return std::move(collector.phases);
}

}  // namespace axisc::motion
