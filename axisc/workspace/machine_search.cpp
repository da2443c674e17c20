#include "axisc/workspace/machine_search.hpp"

#include "configuration/machine_file.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/loading.hpp"

#include <algorithm>
#include <variant>

namespace axisc {

namespace {

/// The lists of a machine are not kept further up.
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

}  // namespace

void MachineSearch::note_readers(Readers& readers) const {
  for (auto const& [folder, machines] : machines_) {
    for (auto const& machine : machines) readers.add(machine.path, machine.asked);
  }
}

bool MachineSearch::Machine::reads(configuration::Files& files, std::string const& wanted) const {
  if (keys.contains(wanted)) return true;
  // Through a link to one of its folders. A link of another name is taken for a file of its own.
  auto const [first, last] = by_name.equal_range(std::string(validator::file_name(wanted)));
  return std::any_of(first, last, [&](auto const& known) { return files.is_same(known.second, wanted); });
}

std::vector<MachineSearch::Machine> const& MachineSearch::machines_in(Buffers& files,
                                                                      std::string const& folder) {
  auto const [known, is_new] = machines_.try_emplace(folder);
  if (!is_new) return known->second;
  auto names = files.names_in(folder);
  std::sort(names.begin(), names.end());
  std::stable_partition(names.begin(), names.end(), is_json);
  for (auto const& name : names) {
    Machine machine{.path = folder + name, .keys = {}, .by_name = {}, .asked = {}};
    if (!is_machine(files, machine.path)) continue;
    Buffers own = files.anew();
    SourceSet sources;
    auto const loaded = validator::load(own, machine.path, options_(machine.path), sources);
    if (auto const* const found = std::get_if<validator::LoadedMachine>(&loaded)) {
      for (auto const& read : found->files) {
        machine.keys.insert(validator::key_of(read));
        machine.by_name.emplace(validator::file_name(read), read);
      }
    }
    machine.asked = own.asked();
    known->second.push_back(std::move(machine));
  }
  return known->second;
}

std::string MachineSearch::machine_of(Buffers& files, std::string const& path) {
  if (is_machine(files, path)) return path;
  auto const wanted = validator::key_of(path);
  auto folder = path;
  for (int i = 0; i < most_folders && folder.size() > 1; ++i) {
    if (folder.ends_with('/')) folder.pop_back();
    folder.resize(folder.size() - validator::file_name(folder).size());
    for (auto const& machine : machines_in(files, folder)) {
      if (machine.reads(files, wanted)) return machine.path;
    }
  }
  return path;
}

std::string machine_of(configuration::Files& files, std::string const& path, OptionsOf const& options) {
  Documents const none;
  Buffers buffers(none, files);
  return MachineSearch(options).machine_of(buffers, path);
}

}  // namespace axisc
