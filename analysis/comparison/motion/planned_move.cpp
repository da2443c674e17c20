#include "analysis/comparison/motion/planned_move.hpp"

#include "analysis/motion/interpolator.hpp"
#include "analysis/motion/look_ahead.hpp"

namespace axisc::comparison {

namespace {

class Samples final : public motion::SampleSink {
 public:
  Samples(motion::Point const& begin, std::size_t most) : setpoints{begin}, most_(most) {}

  [[nodiscard]] double room() const override {
    return is_complete ? static_cast<double>(most_) - static_cast<double>(setpoints.size()) : -1;
  }
  void no_room(motion::PathBlock const& /*block*/) override { is_complete = false; }
  void sample(motion::Point const& setpoint, double /*velocity*/,
              motion::PathBlock const& /*block*/) override {
    setpoints.push_back(setpoint);
  }
  void corner(motion::PathBlock const& /*block*/, motion::PathBlock const* /*next*/, double /*block_cycles*/,
              motion::BlockMotion const& /*motion*/) override {}

  std::vector<motion::Point> setpoints;
  bool is_complete = true;

 private:
  std::size_t most_;
};

}  // namespace

std::optional<std::vector<motion::Point>> planned_setpoints(Move const& move, motion::PathDynamics dynamics,
                                                            Combination const& readings, std::size_t most) {
  dynamics.readings = readings_of(readings);
  Samples samples(move.begin, most);
  motion::Interpolator interpolator(samples);
  motion::LookAhead planner(motion::PathLimits(std::move(dynamics)), false, interpolator);
  planner.begin(move.begin, {}, 1);
  for (auto const& block : move.blocks) {
    planner.add(block);
    if (!samples.is_complete) return std::nullopt;
  }
  planner.stop();
  if (!samples.is_complete) return std::nullopt;
  return std::move(samples.setpoints);
}

}  // namespace axisc::comparison
