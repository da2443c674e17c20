#include "cli/inputs.hpp"

#include "cli/codes.hpp"
#include "cli/disk_files.hpp"
#include "cli/machine_outline.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <variant>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

struct Found {
  std::string path;
  fs::path identity;            ///< the same for every way to write the path
  std::vector<fs::path> named;  ///< lists and programs of a machine file
};

fs::path identity_of(fs::path const& path) {
  std::error_code error;
  auto const canonical = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : canonical;
}

/// What a machine file names; nothing for a list, and for JSON that is no machine file. One that cannot be read counts,
/// so that the check complains about it.
MachineOutline outline_of(std::string const& path) {
  if (!has_extension(path, ".json")) return {};
  DiskFiles files;
  auto const bytes = files.read(path);
  auto const* const text = std::get_if<std::string>(&bytes);
  return text == nullptr ? MachineOutline{.is_machine = true, .named = {}} : read_machine_outline(*text);
}

Found found(std::string path, MachineOutline const& outline) {
  Found result{.path = std::move(path), .identity = {}, .named = {}};
  result.identity = result.path == "-" ? fs::path("-") : identity_of(result.path);
  auto const folder = fs::path(result.path).parent_path();
  for (auto const& file : outline.named) result.named.push_back(identity_of(folder / file));
  return result;
}

bool may_be_input(fs::directory_entry const& entry) {
  std::error_code error;
  auto const type = entry.status(error).type();
  // A link that leads nowhere is reported when it is read.
  if (type != fs::file_type::regular && type != fs::file_type::not_found) return false;
  auto const name = entry.path().filename().string();
  return has_extension(name, ".lis") || has_extension(name, ".json") || has_extension(name, ".nc");
}

void expand_folder(std::string const& folder, std::vector<Found>& inputs, std::vector<Failure>& failures) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (may_be_input(*entry)) paths.push_back(entry->path().lexically_normal());
  }
  if (error) {
    failures.push_back(
        Failure({.text = Text::ax9001_folder, .arguments = {{"folder", folder}, {"reason", error.message()}}},
                cannot_read));
    return;
  }
  std::sort(paths.begin(), paths.end());
  auto const before = inputs.size();
  for (auto const& path : paths) {
    auto const outline = outline_of(path.string());
    if (has_extension(path.string(), ".json") && !outline.is_machine) continue;
    inputs.push_back(found(path.string(), outline));
  }
  if (inputs.size() == before) {
    failures.push_back(
        Failure({.text = Text::ax9001_folder_empty, .arguments = {{"folder", folder}}}, cannot_read));
  }
}

}  // namespace

Inputs expand_inputs(std::vector<std::string> const& named) {
  Inputs result;
  std::vector<Found> inputs;
  for (auto const& name : named) {
    std::error_code error;
    if (name != "-" && fs::is_directory(name, error)) {
      expand_folder(name, inputs, result.failures);
    } else {
      inputs.push_back(found(name, outline_of(name)));
    }
  }
  std::set<fs::path> through_machine;
  for (auto const& input : inputs) through_machine.insert(input.named.begin(), input.named.end());
  std::set<fs::path> taken;
  for (auto& input : inputs) {
    bool const again = !taken.insert(input.identity).second;
    if (!again && !through_machine.contains(input.identity)) result.paths.push_back(std::move(input.path));
  }
  return result;
}

}  // namespace axisc::cli
