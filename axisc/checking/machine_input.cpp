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

std::optional<validator::CheckResult> check_machine(Workspace& workspace, std::string const& path,
                                                    ErrorSink const& errors, SourceSet& sources,
                                                    std::optional<validator::LoadedMachine>& loaded) {
  auto const options = workspace.options_of(path);
  auto& files = workspace.files();
  auto read = validator::load(files, path, options, sources);
  if (auto const* const error = std::get_if<configuration::FileError>(&read)) throw unreadable(path, *error);
  loaded = std::get<validator::LoadedMachine>(std::move(read));
  std::vector<Finding> found;
  auto result = validator::check(*loaded, files, options, sources, [&found](Finding& finding) {
    if (finding.severity == Severity::error) found.push_back(std::move(finding));
  });
  if (!found.empty()) {
    errors.take(found, sources);
    return std::nullopt;
  }
  require_machine(path, result, sources, errors.language);
  return result;
}

}  // namespace axisc
