// What a planner emits, recorded.
#pragma once

#include "analysis/motion/look_ahead.hpp"

#include <limits>
#include <vector>

namespace axisc::test {

struct PlannedBlock {
  motion::PathBlock block;
  std::vector<motion::Phase> phases;
  motion::BlockMotion motion;
  bool stops = false;  ///< at its end

  [[nodiscard]] double cycles() const {
    double sum = 0;
    for (auto const& phase : phases) sum += phase.duration;
    return sum;
  }
};

struct PlannedPath final : motion::PathSink {
  std::vector<PlannedBlock> blocks;
  std::vector<motion::Phase> open;

  void piece(motion::PathBlock const&, motion::Phase const& phase) override { open.push_back(phase); }
  void block_end(motion::PathBlock const& block, motion::PathBlock const* next,
                 motion::BlockMotion const& motion) override {
    blocks.push_back({.block = block, .phases = std::move(open), .motion = motion, .stops = next == nullptr});
    open.clear();
  }
  void rest(motion::PathBlock const&, std::uint64_t) override {}
  void exact_stop(motion::PathBlock const&) override {}
  [[nodiscard]] double room() const override { return std::numeric_limits<double>::infinity(); }
};

}  // namespace axisc::test
