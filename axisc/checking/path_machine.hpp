// The machine whose paths `contour` and `simulate` follow: checked, compiled, and ready for the runtime.
#pragma once

#include "analysis/motion/group_runtime.hpp"
#include "analysis/motion/program/interpreter.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/workspace/machine_search.hpp"
#include "codegen/image_writer.hpp"
#include "configuration/machine/machine.hpp"
#include "validator/commands/command_check.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct CheckedMachine {
  machine::Machine machine;
  std::vector<std::string> files;  ///< that were read
  /// Where the input is a list of one axis of this machine: the axis, and its channel.
  std::optional<std::string> axis = {}, group = {};
};

struct MachineRequest {
  std::string input;   ///< as the user names it
  bool alone = false;  ///< a list by itself, not in its machine
};

/// The machine of an input: for a folder the only one in it, for a list the one that it belongs to. Failure
/// for a folder with none, or with several.
[[nodiscard]] Belonging machine_of_input(Workspace& workspace, MachineRequest const& request);

/// Failure for another name than those of the axes.
[[nodiscard]] std::size_t axis_named(machine::Machine const& machine, std::string const& name);

/// The axis that the list of that name makes; none where it makes none or several.
[[nodiscard]] std::optional<std::size_t> axis_of_list(validator::LoadedMachine const& loaded,
                                                      SourceSet const& sources, std::string const& list);

/// The machine of a request, checked, with what was read: `loaded` refers to `sources`.
struct RequestedMachine {
  /// Failure for an unreadable file and for an unknown NC cycle time.
  RequestedMachine(Workspace& workspace, MachineRequest const& request, ErrorSink const& errors);
  RequestedMachine(RequestedMachine const&) = delete;
  RequestedMachine& operator=(RequestedMachine const&) = delete;

  /// That of the name, without one that of the list, or the only one. Failure where it is none of them.
  [[nodiscard]] std::size_t axis(std::optional<std::string> const& name) const;

  std::string path;
  std::string input;  ///< the list, where the request is one in its machine
  SourceSet sources;
  std::optional<validator::LoadedMachine> loaded;
  std::optional<validator::CheckResult> checked;  ///< with a machine; none after errors
};

/// Checks a list, a machine file, a start-up list, or the only machine in a folder; a list is judged in its
/// machine. After errors nothing is returned. Failure as above.
[[nodiscard]] std::optional<CheckedMachine> checked_machine(Workspace& workspace,
                                                            MachineRequest const& request,
                                                            ErrorSink const& errors);

/// The image of a machine, in memory: without bounds where nothing else is asked for, as they are not needed
/// to execute it.
[[nodiscard]] ImageFile image_of(machine::Machine const& machine, std::string const& path,
                                 codegen::ImageOptions const& options = {});

/// The runtime for one of the machine's groups. Failure for more axes than a path has.
/// With `machine`, whose axes the group's are, also what delays their positions after the filters.
[[nodiscard]] motion::GroupRuntime group_runtime(ImageFile const& image, machine::MachineGroup const& group,
                                                 std::string const& path,
                                                 machine::Machine const* machine = nullptr);

/// The group of that name; the first one without a name. Failure if there is none.
[[nodiscard]] std::size_t chosen_group(machine::Machine const& machine,
                                       std::optional<std::string> const& name, std::string const& path);

/// Limits of the keywords in the group's commands.
[[nodiscard]] validator::CommandLimits command_limits(machine::Machine const& machine,
                                                      machine::MachineGroup const& group);

/// What is wrong with a command that a person typed, and what would be right; empty for a command without
/// mistakes.
[[nodiscard]] std::string why_unusable(validator::CheckedCommand const& checked, Language language);

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
