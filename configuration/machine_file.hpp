// The content of a machine file: names of files that have not been read yet.
#pragma once

#include "configuration/json_reading.hpp"
#include "configuration/machine/machine.hpp"
#include "configuration/machine_file_report.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace axisc::configuration {

struct MachineFileAxis {
  LocatedText name;
  LocatedText list;
  std::optional<LocatedText> drive;  ///< SERCOS, PROFIDRIVE, CANopen, …; wins over kenngr.antr_typ
  std::optional<LocatedText> position_control;  ///< drive or cnc
  std::optional<machine::AxisType> type;
  double drive_delay_us = 0;  ///< of the drive itself: nothing else tells
};

struct MachineFileGroup {
  std::optional<LocatedText> name;
  std::vector<LocatedText> axes;
  std::vector<LocatedText> programs;  ///< checked against this group alone
  std::optional<LocatedText> channel_list;
  std::optional<std::uint32_t> look_ahead_blocks;  ///< as start-up lists say it (P-STUP-00071)
};

struct MachineFileGantry {
  LocatedText master;
  std::vector<LocatedText> slaves;
};

struct MachineFile {
  std::optional<LocatedText> machine;
  std::optional<design::CycleTime> cycle_time;
  std::optional<LocatedText> default_list;
  std::optional<LocatedText> default_channel_list;
  std::vector<MachineFileAxis> axes;
  std::vector<MachineFileGroup> groups;
  std::vector<MachineFileGantry> gantries;
  std::vector<LocatedText> programs;     ///< checked against every group
  std::vector<LocatedText> filter_sets;  ///< commands that programs may use besides those in `programs`
  bool inch = false;                     ///< lengths in programs are inches
  MachineFileReport report;
};

/// The code of every mistake in a machine file.
inline constexpr Code machine_file_code{4020};

/// Reads `sources[source]`; mistakes become AX4020 findings (place and sentences) and are left out of the
/// result. Axes without name or list, and repeated ones, are left out.
[[nodiscard]] MachineFile read_machine_file(SourceSet const& sources, SourceId source,
                                            std::deque<Finding>& findings);

/// The shape of a machine file.
extern JsonShape const machine_file_shape;

/// True for text that is meant as a machine file, however broken: an object, or at least a key "axes".
[[nodiscard]] bool looks_like_machine_file(std::string_view bytes);

}  // namespace axisc::configuration
