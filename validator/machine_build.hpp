// From checked lists to the typed machine.
#pragma once

#include "validator/check.hpp"
#include "validator/loading.hpp"

#include <vector>

namespace axisc::validator {

struct BuiltMachine {
  Machine machine;
  std::vector<NotCompiled> not_compiled;
};

/// Call it only where no error was found and every file was read.
[[nodiscard]] BuiltMachine build_machine(LoadedMachine const& loaded, SourceSet const& sources);

}  // namespace axisc::validator
