// Every NC cycle of a simulation as CSV, written while it runs.
#pragma once

#include "analysis/motion/closed_loop.hpp"
#include "analysis/motion/simulation.hpp"
#include "axisc/environment/text_sink.hpp"
#include "configuration/machine/path_dynamics.hpp"
#include "design/units.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct SimulatedPath {
  std::string group;
  std::vector<std::string> axes;
  design::CycleTime cycle_time;
  machine::ChannelDynamics dynamics = {};
};

/// Time, block, path velocity, per axis setpoint, filtered setpoint and axis error, contour deviation.
class CycleWriter {
 public:
  CycleWriter(SimulatedPath const& path, TextSink sink);
  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block);
  void finish();

 private:
  SimulatedPath const& path_;
  TextSink sink_;
  std::string text_;
  std::vector<double> row_;
  std::uint64_t cycles_ = 0;
};

/// An axis in its closed loop: the records of both moves side by side.
[[nodiscard]] std::string plant_table(motion::LoopRecord const& without, motion::LoopRecord const& with,
                                      double cycle_seconds);

}  // namespace axisc
