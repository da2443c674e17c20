// Builds the typed machine from checked lists.
#pragma once

#include "configuration/files.hpp"
#include "validator/loading/loading.hpp"
#include "validator/not_compiled.hpp"
#include "validator/views/axis_views.hpp"

#include <deque>
#include <vector>

namespace axisc::validator {

struct BuiltMachine {
  machine::Machine machine;
  std::vector<NotCompiled> not_compiled;
};

/// Call it only if no error was found and every file was read. `views` has one entry per axis. The machine
/// reads programs again from `files` when their bytes are needed.
[[nodiscard]] BuiltMachine build_machine(LoadedMachine const& loaded, std::deque<AxisViews> const& views,
                                         SourceSet const& sources, configuration::Files& files);

}  // namespace axisc::validator
