#include "validator/check.hpp"

#include "validator/engine.hpp"
#include "validator/loading.hpp"
#include "validator/machine_build.hpp"

#include <utility>

namespace axisc::validator {

CheckResult check(Files& files, std::string const& path, CheckOptions const& options, SourceSet& sources,
                  FindingSink const& sink) {
  CheckResult result;
  std::variant<LoadedMachine, FileError> loaded = load(files, path, options, sources);
  if (auto const* const error = std::get_if<FileError>(&loaded)) {
    result.unreadable = *error;
    return result;
  }
  auto& machine = std::get<LoadedMachine>(loaded);
  result.cycle_time_known = machine.cycle_time.has_value();
  // Silenced or not: what cannot be understood in a machine file is not in the machine.
  bool const is_understood = machine.complete && machine.findings.findings.empty();

  EngineResult const judged = run_rules(machine, std::move(machine.findings), options, sources, sink);
  result.cycle_time_assumed = judged.cycle_time_assumed;
  if (options.machine && !judged.has_errors && is_understood && !machine.axes.empty()) {
    BuiltMachine built = build_machine(machine, sources, files);
    result.machine = std::move(built.machine);
    result.not_compiled = std::move(built.not_compiled);
  }
  result.files = std::move(machine.files);
  return result;
}

CheckResult check(Files& files, std::string const& path, CheckOptions const& options, SourceSet& sources) {
  std::vector<Finding> findings;
  CheckResult result = check(files, path, options, sources,
                             [&findings](Finding& finding) { findings.push_back(std::move(finding)); });
  result.findings = std::move(findings);
  return result;
}

}  // namespace axisc::validator
