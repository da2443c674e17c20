// What recordings of ordinary motion tell of the mechanics of an axis.
#pragma once

#include "analysis/tuning/rigid_model/rigid_model.hpp"
#include "axisc/answers/identify/motion_signals.hpp"
#include "axisc/checking/path_machine.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct IdentifyQuestion {
  MachineRequest machine;
  std::vector<std::string> recordings;  ///< of the axis, at least one
  std::optional<std::string> axis;      ///< none: that of the list, or the only one
  MotionColumns columns;                ///< of each recording
  PositionUnits units = {};
};

/// A column that was used, and for what: "position", or "run.csv: position" of one of several files.
struct UsedColumn {
  std::string signal;
  MappedColumn column;
};

struct IdentifiedAxis {
  std::string axis;
  bool is_rotary = false;
  bool is_unit_guessed = false;  ///< that of a position
  ForceUnit force;
  double sample_time_ms = 0;
  tuning::RigidModel model;  ///< with a mass
  std::vector<UsedColumn> mapping;
  std::optional<double> kv;        ///< 1/s, of the first gear (P-AXIS-00099), where a list says it
  std::vector<std::string> files;  ///< that were read
};

/// None where `errors` of the machine prevent it. Failure (AX9005) where the recordings do not show the mass:
/// it says why, and what to record.
[[nodiscard]] std::optional<IdentifiedAxis> identified_axis(Workspace& workspace,
                                                            IdentifyQuestion const& question,
                                                            ErrorSink const& errors);

}  // namespace axisc
