// The filters that the commands of a channel's programs switch, and the kernels that they ask for.
#pragma once

#include "configuration/machine/filter_command.hpp"
#include "validator/check.hpp"
#include "validator/loading/loading.hpp"
#include "validator/not_compiled.hpp"
#include "validator/options.hpp"

#include <vector>

namespace axisc::validator {

/// An axis of the channel has the FIR time delay: orders of its commands end at 100.
[[nodiscard]] bool has_time_delay(LoadedMachine const& machine, LoadedGroup const& group);

/// MachineGroup::filter_sets: the distinct parameter sets that the commands of the group's programs and the
/// machine's filter_sets ask for, in the order of their first use. Commands of a program are followed in the
/// order of its lines, so that one without ON keeps the parameters of earlier ones; each entry of filter_sets
/// is independent. A command with a variable asks for none, because its value is unknown, nor does one that
/// builds on it; a command whose mistake was silenced is added to `not_compiled`.
[[nodiscard]] std::vector<machine::FilterParameters> filter_sets_of(LoadedMachine const& machine,
                                                                    LoadedGroup const& group,
                                                                    SourceSet const& sources,
                                                                    std::vector<NotCompiled>& not_compiled);

/// A program of the group, or filter_sets of the machine, has a command of this kind.
[[nodiscard]] bool has_command(LoadedMachine const& machine, LoadedGroup const& group,
                               grammar::CommandKind kind);

}  // namespace axisc::validator
