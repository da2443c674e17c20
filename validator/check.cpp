#include "validator/check.hpp"

#include "validator/engine.hpp"
#include "validator/loading.hpp"
#include "validator/machine_build.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator {
namespace {

Finding assumed_cycle_time(std::string const& path) {
  Rule const& rule = *find_rule(Code{9006});
  Finding finding;
  finding.code = rule.code;
  finding.name = rule.name;
  finding.severity = rule.severity;
  finding.file = path;
  finding.message = {.text = Text::ax9006, .arguments = {}};
  finding.help.push_back({.text = Text::ax9006_help, .arguments = {}});
  return finding;
}

bool is_disabled(CheckOptions const& options, Code code) {
  return std::find(options.disabled.begin(), options.disabled.end(), code) != options.disabled.end();
}

}  // namespace

CheckResult check(Files& files, std::string const& path, CheckOptions const& options, SourceSet& sources) {
  CheckResult result;
  std::variant<LoadedMachine, FileError> loaded = load(files, path, options, sources);
  if (auto const* const error = std::get_if<FileError>(&loaded)) {
    result.unreadable = *error;
    return result;
  }
  auto& machine = std::get<LoadedMachine>(loaded);
  result.cycle_time_known = machine.cycle_time.has_value();

  EngineResult judged = run_rules(machine, options, sources);
  result.findings = std::move(judged.findings);
  bool const has_error =
      std::any_of(result.findings.begin(), result.findings.end(),
                  [](Finding const& finding) { return finding.severity == Severity::error; });
  result.cycle_time_assumed = judged.cycle_time_needed && !result.cycle_time_known;
  if (result.cycle_time_assumed && !is_disabled(options, Code{9006})) {
    result.findings.insert(result.findings.begin(), assumed_cycle_time(path));
  }
  if (options.machine && !has_error && machine.complete && !machine.axes.empty()) {
    BuiltMachine built = build_machine(machine, sources, files);
    result.machine = std::move(built.machine);
    result.not_compiled = std::move(built.not_compiled);
  }
  result.files = std::move(machine.files);
  return result;
}

}  // namespace axisc::validator
