// A program's path through planner, interpolator and runtime, with what the filters do to it.
//
// A #FILTER command acts while the axes stand: the path stops, the filters settle, the command is executed. Blocks between
// two commands are a pass.
#pragma once

#include "axisrt.h"
#include "motion/contour/contour_meter.hpp"
#include "motion/group_runtime.hpp"
#include "motion/interpolator.hpp"
#include "motion/look_ahead.hpp"
#include "motion/path_listener.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace axisc::motion {

/// What happened on a block, or in a pass. Errors are position units.
struct PathSummary {
  double cycles = 0;  ///< duration; of a pass until its filters have settled
  Point axis_error{};
  double deviation = 0;
  double lag = 0;  ///< largest amount along straight stretches
};

struct BlockSummary : PathSummary {
  std::uint64_t index = 0;
  std::uint32_t line = 0;
  std::string label;
};

struct PassSummary : PathSummary {
  std::string command;     ///< as the program writes it; empty: as at start-up
  std::uint32_t line = 0;  ///< of the command
  std::uint64_t blocks = 0;
};

class SimulationListener {
 public:
  virtual ~SimulationListener() = default;
  /// A setpoint, in the order of cycles; `block` is the one it lies on.
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
  axisrt_status status = AXISRT_OK;          ///< of a step or command
  std::string command;                       ///< that the runtime refused
  std::optional<std::size_t> blocking_axis;  ///< whose filters block the constant part
};

class Simulation final : public PathListener, private SampleSink, private MeasuredSink {
 public:
  /// `probe` is a second runtime of the same image: on it the chains are learnt and corners are tried.
  Simulation(GroupRuntime runtime, GroupRuntime probe, PathLimits limits, bool constant_velocity,
             SimulationListener& listener);

  void motion(ProgrammedBlock const& block) override;
  void command(FilterChange const& change) override;
  /// The path stops; it goes on when the filters have settled and the dwell is over.
  void stop(double cycles) override;
  /// The end of the program; nothing may follow.
  void end() override;

  [[nodiscard]] std::optional<SimulationFailure> const& failure() const { return failure_; }
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

 private:
  void sample(Point const& setpoint, double velocity, PathBlock const& block) override;
  void corner(PathBlock const& block, PathBlock const* next, double block_cycles) override;
  void measured(MeasuredPoint const& point) override;

  void begin_pass(std::string command, std::uint32_t line);
  void open_pass();
  void finish_pass();
  void rest(double cycles);
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
  LookAhead look_ahead_;
  ContourPoint last_{};  ///< the setpoint that was given last
  bool settled_ = true;  ///< the filters have come to rest there
  double tolerance_ = 0;
  double acceleration_factor_ = 1;
  PassSummary pass_;
  bool pass_open_ = false;
  std::uint64_t pass_begin_ = 0;
  std::deque<BlockSummary> open_blocks_;
  std::uint64_t cycles_ = 0;
  std::uint64_t blocks_ = 0;
  std::optional<SimulationFailure> failure_;
};

}  // namespace axisc::motion
