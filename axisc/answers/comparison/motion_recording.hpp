// A program's path beside what a scope recorded of it.
#pragma once

#include "analysis/comparison/motion/motion_comparison.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/answers/simulation/followed_program.hpp"
#include "axisc/files/recorded_positions.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

struct RecordedMotion {
  std::string program, recording;     ///< paths, for readers
  std::vector<std::string> axes;      ///< with a column
  std::vector<MappedColumn> mapping;  ///< of the axes
  std::size_t cycles = 0;             ///< of the recording
  std::size_t lost = 0, repeated = 0;
  std::size_t jumps = 0;   ///< by a modulo range; they are taken out
  bool is_rotary = false;  ///< every recorded axis
  double allowed = 0;  ///< largest deviation that rounding explains, position units; of the coarsest column
  machine::MotionReadings in_force;
  comparison::MotionComparison result;
};

struct MotionRecording {
  std::string path;
  std::vector<AxisColumn> columns = {};
  PositionUnits units = {};
};

/// Follows a program that survey_program() accepted. Failure for a program that cannot be compared, at its
/// line; for a recording in which its moves are not found; and those of read_recorded_positions().
[[nodiscard]] RecordedMotion compare_program(ProgramLines& program, ProgramRequest const& request,
                                             machine::Machine const& machine, std::size_t index,
                                             MotionRecording const& recording);

}  // namespace axisc
