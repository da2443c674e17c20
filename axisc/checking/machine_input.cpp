#include "axisc/checking/machine_input.hpp"

#include "axisc/checking/compilable.hpp"
#include "axisc/files/disk_files.hpp"

#include <utility>
#include <variant>
#include <vector>

namespace axisc {

std::optional<validator::CheckResult> check_machine(Workspace& workspace, std::string const& path,
                                                    ErrorSink const& errors) {
  SourceSet sources;
  std::optional<validator::LoadedMachine> loaded;
  return check_machine(workspace, path, errors, sources, loaded);
}

validator::LoadedMachine loaded_machine(Workspace& workspace, std::string const& path, SourceSet& sources) {
  auto read = validator::load(workspace.files(), path, workspace.options_of(path), sources);
  if (auto const* const error = std::get_if<configuration::FileError>(&read)) throw unreadable(path, *error);
  return std::get<validator::LoadedMachine>(std::move(read));
}

std::optional<validator::CheckResult> check_machine(Workspace& workspace, std::string const& path,
                                                    ErrorSink const& errors, SourceSet& sources,
                                                    std::optional<validator::LoadedMachine>& loaded) {
  loaded = loaded_machine(workspace, path, sources);
  std::vector<Finding> found;
  auto result = validator::check(*loaded, workspace.files(), workspace.options_of(path), sources,
                                 [&found](Finding& finding) {
                                   if (finding.severity == Severity::error)
                                     found.push_back(std::move(finding));
                                 });
  if (!found.empty()) {
    errors.take(found, sources);
    return std::nullopt;
  }
  require_machine(path, result, sources, errors.language);
  return result;
}

}  // namespace axisc
