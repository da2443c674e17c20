#include "cli/options/machine_outline.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

using json_type = nlohmann::json;

void add_list(std::vector<std::string>& named, json_type const& object, char const* key) {
  if (!object.is_object()) return;
  auto const found = object.find(key);
  if (found != object.end() && found->is_string()) named.push_back(found->get<std::string>());
}

void add_programs(std::vector<std::string>& named, json_type const& object) {
  if (!object.is_object()) return;
  auto const found = object.find("programs");
  if (found == object.end() || !found->is_array()) return;
  for (auto const& program : *found) {
    if (program.is_string()) named.push_back(program.get<std::string>());
  }
}

}  // namespace

MachineOutline read_machine_outline(std::string_view json) {
  auto const document = json_type::parse(json.begin(), json.end(), nullptr, false);
  if (document.is_discarded()) {
    // A malformed machine file still counts as one: its mistake becomes a finding.
    return {.is_machine = json.find("\"axes\"") != std::string_view::npos};
  }
  MachineOutline outline;
  if (!document.is_object() || !document.contains("axes")) return outline;
  outline.is_machine = true;
  add_list(outline.lists, document, "default_list");
  for (auto const& axis : document["axes"]) add_list(outline.lists, axis, "list");
  add_programs(outline.programs, document);
  if (document.contains("groups")) {
    for (auto const& group : document["groups"]) add_programs(outline.programs, group);
  }
  return outline;
}

bool has_extension(std::string_view path, std::string_view extension) {
  if (path.size() <= extension.size()) return false;
  return ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

}  // namespace axisc::cli
