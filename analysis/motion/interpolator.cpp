#include "analysis/motion/interpolator.hpp"

#include <algorithm>

namespace axisc::motion {

void Interpolator::piece(PathBlock const& block, Phase const& phase) {
  double const duration = phase.duration;
  // A sample at the beginning may be due still.
  if (!(duration + 1 - to_sample_ <= sink_.room())) return sink_.no_room(block);
  sink_.phase(block, phase);
  for (; to_sample_ <= duration - same_time; to_sample_ += 1) {
    double const way = std::min(passed_ + phase.way_at(to_sample_), block.length);
    sink_.sample(block.path.at(way), phase.velocity_at(to_sample_), block);
  }
  to_sample_ = std::max(0.0, to_sample_ - duration);
  passed_ += phase.length;
  velocity_ = phase.velocity_out();
  block_cycles_ += duration;
}

void Interpolator::block_end(PathBlock const& block, PathBlock const* next, BlockMotion const& motion) {
  bool const on_cycle = to_sample_ <= 2 * same_time;
  sink_.corner(block, next, block_cycles_, motion);
  passed_ = 0;
  block_cycles_ = 0;
  if (next != nullptr) {
    // A sample on the corner itself is exactly the corner.
    if (!on_cycle) return;
    sink_.sample(block.end, velocity_, *next);
    to_sample_ = 1;
    return;
  }
  sink_.sample(block.end, 0, block);
  to_sample_ = 1;
}

void Interpolator::rest(PathBlock const& block, std::uint64_t cycles) {
  for (std::uint64_t n = 0; n < cycles; ++n) sink_.sample(block.end, 0, block);
}

}  // namespace axisc::motion
