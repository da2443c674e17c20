#include "axisc/workspace/judged_inputs.hpp"

#include "system/path.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace axisc {

namespace {

/// The folder that is an input and holds the file, with `/` at the end.
std::string named_folder(Inputs const& inputs, std::string const& path) {
  std::string longest;
  for (auto const& named : inputs.named) {
    auto folder = validator::key_of(named);
    if (folder == ".") continue;
    if (!folder.ends_with('/')) folder += '/';
    if (path.starts_with(folder) && folder.size() > longest.size()) longest = std::move(folder);
  }
  return longest;
}

}  // namespace

std::vector<Belonging> belonging_of(Inputs const& inputs, configuration::Files& files) {
  OpenDocuments const no_documents;
  Buffers buffers(no_documents, files);
  MachineSearch search;
  std::vector<Belonging> found;
  found.reserve(inputs.paths.size());
  for (auto const& path : inputs.paths) {
    auto const from = inputs.found.contains(path) ? std::optional(named_folder(inputs, path)) : std::nullopt;
    found.push_back(path == "-" ? Belonging{.machine = path, .name = path}
                                : search.machine_of(buffers, path, from));
  }
  return found;
}

void judge_in_machines(Inputs& inputs, configuration::Files& files) {
  std::unordered_set<std::string> const whole(inputs.paths.begin(), inputs.paths.end());
  std::vector<std::string> judged;
  auto belongings = belonging_of(inputs, files);
  for (std::size_t i = 0; i < belongings.size(); ++i) {
    auto const& path = inputs.paths[i];
    auto& belonging = belongings[i];
    if (belonging.machine == path) {
      judged.push_back(path);
      continue;
    }
    // The machine is an input of its own and shows everything.
    if (whole.contains(belonging.machine)) continue;
    auto const [shown, is_first] = inputs.shown.try_emplace(belonging.machine);
    if (is_first) judged.push_back(belonging.machine);
    shown->second.push_back(std::move(belonging.name));
  }
  inputs.paths = std::move(judged);
}

}  // namespace axisc
