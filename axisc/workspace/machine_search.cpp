#include "axisc/workspace/machine_search.hpp"

#include "configuration/machine_file.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/loading.hpp"

#include <algorithm>
#include <variant>

namespace axisc {

namespace {

/// The lists of a machine are not kept further up.
constexpr int most_folders = 16;

/// With `/` at the end; "" is the working folder.
std::string folder_of(std::string const& path) {
  return path.substr(0, path.size() - validator::file_name(path).size());
}

/// There is nothing above the root.
std::optional<std::string> folder_above(std::string folder) {
  if (folder == "/") return std::nullopt;
  if (folder.empty() || folder == "../" || folder.ends_with("/../")) return folder + "../";
  folder.pop_back();
  return folder_of(folder);
}

bool is_json(std::string const& path) {
  return ascii::has_extension(path, ".json");
}

bool is_machine(configuration::Files& files, std::string const& path) {
  if (configuration::is_project_name(path)) return true;
  if (!is_json(path) && !ascii::has_extension(path, ".lis") && !configuration::is_xml_name(path)) {
    return false;
  }
  // The key is at the beginning; large files of measurements are not read to their end.
  constexpr std::size_t most_bytes = std::size_t{4} << 20U;
  bool found = false;
  std::size_t seen = 0;
  (void)files.read_pieces(path, [&](std::string_view piece) {
    seen += piece.size();
    found = is_json(path) ? piece.find("\"axes\"") != std::string_view::npos
                          : configuration::looks_like_start_up_list(piece) ||
                                configuration::xml_list_kind(piece) == configuration::ListKind::startup;
    return is_json(path) && !found && seen < most_bytes;
  });
  return found;
}

}  // namespace

void MachineSearch::note_readers(Readers& readers) const {
  for (auto const& [folder, machines] : machines_) {
    for (auto const& machine : machines) readers.add(machine.path, machine.asked);
  }
}

std::optional<std::string> MachineSearch::Machine::name_of(configuration::Files& files,
                                                           std::string const& wanted) const {
  if (auto const same = names.find(wanted); same != names.end()) return same->second;
  // Through a link to one of its folders. A link of another name is taken for a file of its own.
  auto const [first, last] = by_name.equal_range(std::string(validator::file_name(wanted)));
  auto const same =
      std::find_if(first, last, [&](auto const& known) { return files.is_same(known.second, wanted); });
  return same == last ? std::nullopt : std::optional(same->second);
}

std::vector<MachineSearch::Machine> const& MachineSearch::machines_in(Buffers& files,
                                                                      std::string const& folder) {
  auto const [known, is_new] = machines_.try_emplace(folder);
  if (!is_new) return known->second;
  auto names = files.names_in(folder);
  std::sort(names.begin(), names.end());
  std::stable_partition(names.begin(), names.end(), is_json);
  for (auto const& name : names) {
    Machine machine{.path = folder + name, .names = {}, .by_name = {}, .asked = {}};
    if (!is_machine(files, machine.path)) continue;
    Buffers own = files.anew();
    SourceSet sources;
    auto const loaded = validator::load(own, machine.path, {}, sources);
    if (auto const* const found = std::get_if<validator::LoadedMachine>(&loaded)) {
      for (auto const& read : found->files) {
        machine.names.emplace(validator::key_of(read), read);
        machine.by_name.emplace(validator::file_name(read), read);
      }
    }
    machine.asked = own.asked();
    known->second.push_back(std::move(machine));
  }
  return known->second;
}

Belonging MachineSearch::machine_of(Buffers& files, std::string const& path,
                                    std::optional<std::string> const& from) {
  if (is_machine(files, path)) return {.machine = path, .name = path};
  auto const wanted = validator::key_of(path);
  auto folder = from ? folder_above(*from) : std::optional(folder_of(wanted));
  for (int i = 0; i < most_folders && folder; ++i) {
    for (auto const& machine : machines_in(files, *folder)) {
      if (auto name = machine.name_of(files, wanted)) {
        return {.machine = machine.path, .name = *std::move(name)};
      }
    }
    folder = folder_above(*folder);
  }
  return {.machine = path, .name = path};
}

Belonging machine_of(configuration::Files& files, std::string const& path) {
  OpenDocuments const none;
  Buffers buffers(none, files);
  return MachineSearch().machine_of(buffers, path);
}

}  // namespace axisc
