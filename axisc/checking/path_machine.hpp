// The machine whose paths `contour` and `simulate` follow: checked, compiled, and ready for the runtime.
#pragma once

#include "axisc/checking/machine_input.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/image_file.hpp"
#include "machine/machine.hpp"
#include "motion/group_runtime.hpp"
#include "motion/program/interpreter.hpp"
#include "validator/commands/command_check.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct CheckedMachine {
  std::unique_ptr<DiskFiles> disk;  ///< from which the machine reads its NC programs again
  machine::Machine machine;
  std::vector<std::string> files;  ///< that were read
};

/// Checks a list, a machine file, a start-up list, or the only machine in a folder; after errors nothing is returned.
/// Failure for an unreadable file and for an unknown NC cycle time.
[[nodiscard]] std::optional<CheckedMachine> checked_machine(std::string const& input,
                                                            std::optional<design::CycleTime> cycle_time,
                                                            ErrorSink const& errors);

/// The image of a machine, in memory.
[[nodiscard]] ImageFile image_of(machine::Machine const& machine, std::string const& path);

/// The runtime for one of the machine's groups. Failure for more axes than a path has.
[[nodiscard]] motion::GroupRuntime group_runtime(ImageFile const& image, machine::MachineGroup const& group,
                                                 std::string const& path);

/// The group of that name; the first one without a name. Failure if there is none.
[[nodiscard]] std::size_t chosen_group(machine::Machine const& machine,
                                       std::optional<std::string> const& name, std::string const& path);

/// Limits of the keywords in the group's commands.
[[nodiscard]] validator::CommandLimits command_limits(machine::Machine const& machine,
                                                      machine::MachineGroup const& group);

/// One #FILTER command of the command line. Failure for anything else.
[[nodiscard]] machine::FilterCommand read_filter_command(machine::Machine const& machine,
                                                         machine::MachineGroup const& group,
                                                         std::string const& text, Language language);

/// Reads the #FILTER commands of a program that the group runs.
[[nodiscard]] motion::FilterCommandReader filter_command_reader(machine::Machine const& machine,
                                                                machine::MachineGroup const& group);

/// The state that `contour` starts from: every configured FIR and HSC filter is on.
[[nodiscard]] std::vector<machine::FilterCommand> filters_on();

}  // namespace axisc
