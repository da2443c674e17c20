#include "axisc/checking/report_context.hpp"

#include "axisc/environment/version.hpp"
#include "axisc/files/repository.hpp"
#include "system/path.hpp"
#include "validator/engine/rule.hpp"

#include <filesystem>

namespace axisc {

namespace fs = std::filesystem;

ReportContext report_context(std::string const& first_input) {
  ReportContext context;
  context.version = program_version();
  for (auto const& rule : validator::rules()) {
    context.rules.push_back({.code = rule.code,
                             .name = rule.name,
                             .severity = rule.severity,
                             .control = rule.control,
                             .page = page(rule)});
  }
  std::error_code error;
  auto const folder = fs::current_path(error);
  if (error) return context;
  auto root = repository_of(folder);
  if (!root && !first_input.empty()) {
    root = repository_of((folder / system::path_of(first_input)).lexically_normal().parent_path());
  }
  context.paths = {.root = system::name_of(root.value_or(folder)), .folder = system::name_of(folder)};
  return context;
}

}  // namespace axisc
