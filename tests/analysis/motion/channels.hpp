// Checked machines of one channel and their runtimes, for the tests of this folder.
#pragma once

#include "analysis/motion/chain_answer.hpp"
#include "analysis/motion/group_runtime.hpp"
#include "analysis/motion/program/interpreter.hpp"
#include "analysis/motion/simulation.hpp"
#include "configuration/machine/machine.hpp"
#include "validator/commands/command_check.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc::test {

/// Axes X, Y, Z, … of which each filters like this from start-up: 500 mm/s, 10 m/s².
[[nodiscard]] machine::Machine channel_of(std::vector<design::KernelSpecification> const& kernels,
                                          design::CycleTime cycle_time = {});
/// The same with one PT1 per axis.
[[nodiscard]] machine::Machine channel_of_pt1(double time_constant_us, std::size_t axes);

[[nodiscard]] motion::GroupRuntime runtime_of(machine::Machine const& machine);
[[nodiscard]] std::vector<motion::ChainAnswer> answers_of(machine::Machine const& machine);

/// An axis that moves with STEP, in feed blocks as in G00: µm/s, mm/s².
[[nodiscard]] machine::AxisDynamics step_axis(double velocity, double acceleration);
/// Each axis with the same acceleration for all slopes, and its transition weight; the slope is the
/// channel's.
[[nodiscard]] motion::PathDynamics path_of(machine::Machine const& machine);

/// mm/min as units per cycle.
[[nodiscard]] double per_cycle(double feed_mm_per_min, design::CycleTime cycle_time = {});

/// What a simulation said.
struct Recorded final : motion::SimulationListener {
  struct Cycle {
    motion::MeasuredPoint point;
    std::string block;
  };
  std::vector<Cycle> cycles;
  std::vector<motion::BlockSummary> blocks;
  std::vector<motion::PassSummary> passes;

  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) override {
    cycles.push_back({point, block.label});
  }
  void block(motion::BlockSummary const& summary) override { blocks.push_back(summary); }
  void pass(motion::PassSummary const& summary) override { passes.push_back(summary); }
};

/// Reads #FILTER commands as the program does.
[[nodiscard]] motion::FilterCommandReader filter_command_reader(design::CycleTime cycle_time);

/// Runs a program; fails the test where it has a problem.
[[nodiscard]] Recorded simulated(machine::Machine machine, std::string const& program,
                                 bool constant_velocity = false);

/// Runs a program; its problems as "line:column code word", and by how much the control rounds corners.
[[nodiscard]] std::pair<std::vector<std::string>, std::optional<double>> interpreted(
    motion::ProgramChannel const& channel, motion::PathListener& listener, std::string const& program);

}  // namespace axisc::test
