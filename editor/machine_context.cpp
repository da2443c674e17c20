#include "editor/machine_context.hpp"

#include "configuration/machine_file.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml_list.hpp"
#include "diagnostics/ascii.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/loading.hpp"

#include <algorithm>
#include <variant>

namespace axisc::editor {

namespace {

/// Further up nobody keeps the lists of a machine.
constexpr int most_folders = 16;

bool ends_in(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

bool is_json(std::string const& path) {
  return ends_in(path, ".json");
}

bool is_machine(configuration::Files& files, std::string const& path) {
  if (configuration::is_project_name(path)) return true;
  if (!is_json(path) && !ends_in(path, ".lis") && !configuration::is_xml_name(path)) return false;
  bool found = false;
  (void)files.read_pieces(path, [&](std::string_view piece) {
    found = is_json(path) ? piece.find("\"axes\"") != std::string_view::npos
                          : configuration::looks_like_start_up_list(piece) ||
                                configuration::xml_list_kind(piece) == configuration::ListKind::startup;
    return is_json(path) && !found;
  });
  return found;
}

bool reads(configuration::Files& files, std::string const& machine, std::string const& path,
           OptionsOf const& options) {
  SourceSet sources;
  auto const loaded = validator::load(files, machine, options(machine), sources);
  auto const* const found = std::get_if<validator::LoadedMachine>(&loaded);
  return found != nullptr && std::any_of(found->files.begin(), found->files.end(),
                                         [&](std::string const& read) { return files.is_same(read, path); });
}

}  // namespace

std::string machine_of(configuration::Files& files, std::string const& path, OptionsOf const& options) {
  if (is_machine(files, path)) return path;
  auto folder = path;
  for (int i = 0; i < most_folders && folder.size() > 1; ++i) {
    if (folder.ends_with('/')) folder.pop_back();
    folder.resize(folder.size() - validator::file_name(folder).size());
    auto names = files.names_in(folder);
    std::sort(names.begin(), names.end());
    std::stable_partition(names.begin(), names.end(), is_json);
    for (auto const& name : names) {
      auto candidate = folder + name;
      if (is_machine(files, candidate) && reads(files, candidate, path, options)) return candidate;
    }
  }
  return path;
}

}  // namespace axisc::editor
