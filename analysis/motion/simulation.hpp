// A program's path through planner, interpolator and runtime, and the effect of the filters on it.
//
// A #FILTER command acts while the axes are at rest: the path stops, the filters settle, the command is
// executed. The blocks between two commands are a pass.
#pragma once

#include "analysis/motion/contour/contour_meter.hpp"
#include "analysis/motion/group_runtime.hpp"
#include "analysis/motion/interpolator.hpp"
#include "analysis/motion/look_ahead.hpp"
#include "analysis/motion/path_listener.hpp"
#include "analysis/motion/planning/axis_peaks.hpp"
#include "analysis/motion/planning/trapez_time.hpp"
#include "axisrt.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace axisc::motion {

/// The figures of a block, or of a pass. Errors are position units.
struct PathSummary {
  double cycles = 0;  ///< duration; of a pass until its filters have settled
  Point axis_error{};
  double deviation = 0;
  double lag = 0;  ///< largest amount along straight stretches

  [[nodiscard]] double largest_axis_error() const {
    return *std::max_element(axis_error.begin(), axis_error.end());
  }
};

struct BlockSummary : PathSummary {
  BlockMotion motion;
  machine::Slope slope = machine::Slope::step;
  /// #TRANSVELMIN: how much larger the step of an axis' velocity is at its end than the axis should make;
  /// none where it is not.
  std::optional<double> corner_step_share;
  std::uint64_t index = 0;
  std::uint32_t line = 0;
  std::string label;
};

struct PassSummary : PathSummary {
  std::string command;     ///< as in the program; empty: as at start-up
  std::uint32_t line = 0;  ///< of the command
  std::uint64_t blocks = 0;
  std::optional<double> tolerance;  ///< to be monitored (AX_DEV), position units
  AxisPeaks peaks;                  ///< of the setpoints before the filters, within blocks
  /// Duration with TRAPEZ in the place of HSC; none without HSC, or with tolerance monitoring.
  std::optional<double> trapez_cycles;

  [[nodiscard]] bool keeps_tolerance() const { return !tolerance || largest_axis_error() <= *tolerance; }
};

class SimulationListener {
 public:
  virtual ~SimulationListener() = default;
  /// A setpoint, every one in the order of cycles; `block` is the one it lies on, without name and line where
  /// a pass has none yet.
  virtual void cycle(MeasuredPoint const& point, BlockSummary const& block) = 0;
  virtual void block(BlockSummary const& summary) = 0;
  virtual void pass(PassSummary const& summary) = 0;

 protected:
  SimulationListener() = default;
  SimulationListener(SimulationListener const&) = default;
  SimulationListener& operator=(SimulationListener const&) = default;
};

/// Why a simulation ended early.
struct SimulationFailure {
  axisrt_status status = AXISRT_OK;           ///< of a step or command
  std::string command;                        ///< refused by the runtime
  std::optional<std::size_t> blocking_axis;   ///< whose filters block the constant part
  std::optional<std::uint32_t> endless_line;  ///< of the block or dwell that exceeds the cycles of the limits
};

struct SimulationLimits {
  std::uint64_t most_cycles = 100'000'000;  ///< of the whole program
  std::function<void()> working{};          ///< called every millisecond or so
};

class Simulation final : public PathListener, private SampleSink, private MeasuredSink {
 public:
  /// `probe` is a second runtime of the same image, used to learn the chains and to try corners.
  Simulation(GroupRuntime runtime, GroupRuntime probe, PathLimits path, bool constant_velocity,
             SimulationListener& listener, SimulationLimits limits = {});

  void motion(ProgrammedBlock const& block) override;
  void command(FilterChange const& change) override;
  /// Where the axes are fed forward unequally, it acts while they are at rest, as a #FILTER command does.
  void feedforward(bool is_on, std::uint32_t line) override;
  /// The path stops; it continues when the filters have settled and the dwell is over.
  void stop(double cycles, std::uint32_t line) override;
  /// The end of the program; nothing may follow.
  void end() override;

  [[nodiscard]] std::optional<SimulationFailure> const& failure() const { return failure_; }
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

 private:
  [[nodiscard]] double room() const override;
  void no_room(PathBlock const& block) override;
  void sample(Point const& setpoint, double velocity, PathBlock const& block) override;
  void phase(PathBlock const& block, Phase const& phase) override;
  void corner(PathBlock const& block, PathBlock const* next, double block_cycles,
              BlockMotion const& motion) override;
  void exact_stop(PathBlock const& block) override;
  void measured(MeasuredPoint const& point) override;

  void begin_pass(std::string command, std::uint32_t line);
  void open_pass();
  void finish_pass();
  void rest(double cycles, std::uint32_t line);
  void fail_for_length(std::uint32_t line);
  [[nodiscard]] bool come_to_rest();
  [[nodiscard]] bool compares_slopes() const;
  void learn_answers();
  void step(ContourPoint const& point);
  void open_block(PathBlock const& block);
  void close_blocks_before(std::uint64_t index);
  BlockSummary* find_block(std::uint64_t index);
  void take(PathSummary& summary, MeasuredPoint const& point) const;

  GroupRuntime runtime_;
  GroupRuntime probe_;
  SimulationListener& listener_;
  std::vector<ChainAnswer> answers_;
  ContourMeter meter_;
  Interpolator interpolator_;
  bool constant_velocity_;
  Point exact_stop_windows_;  ///< of each axis, position units
  TrapezTime trapez_time_;
  LookAhead look_ahead_;
  ContourPoint last_{};          ///< the setpoint that was given last
  Point filtered_{};             ///< what the filters made of it
  std::uint32_t last_line_ = 0;  ///< of the block that moved last
  bool settled_ = true;          ///< the filters have come to rest there
  bool feeds_forward_ = false;   ///< G135
  double tolerance_ = 0;
  double acceleration_factor_ = 1;
  PassSummary pass_;
  bool pass_open_ = false;
  std::uint64_t pass_begin_ = 0;
  double path_cycles_ = 0;  ///< of the pass, without rests
  std::deque<BlockSummary> open_blocks_;
  std::uint64_t cycles_ = 0;
  std::uint64_t blocks_ = 0;
  SimulationLimits limits_;
  std::optional<SimulationFailure> failure_;
};

}  // namespace axisc::motion
