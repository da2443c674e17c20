#include "configuration/start_up_list.hpp"
#include "editor/open_list.hpp"
#include "editor/requests.hpp"
#include "editor/server.hpp"
#include "editor/uri.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

using Json = nlohmann::json;

std::optional<std::int64_t> version_of(Json const& item) {
  auto const found = item.find("version");
  if (found == item.end() || !found->is_number_integer()) return std::nullopt;
  return found->get<std::int64_t>();
}

/// Its text may say which files belong together.
bool may_be_machine(Document const& document) {
  return !is_list(document.path) ? !document.path.ends_with(".nc")
                                 : configuration::looks_like_start_up_list(document.text);
}

}  // namespace

Json Server::open(Json const& params) {
  auto const& item = params.at("textDocument");
  auto const uri = item.at("uri").get<std::string>();
  // Complete, or not at all.
  Document document{.uri = uri,
                    .path = validator::key_of(path_of(uri)),
                    .text = item.at("text").get<std::string>(),
                    .version = version_of(item)};
  auto& opened = documents_[uri] = std::move(document);
  closed_.erase(uri);
  machines_.erase(uri);
  readings_.clear();
  // A new file may be one that a machine misses.
  if (may_be_machine(opened) || !surroundings_.disk.is_file(opened.path)) return check_all(params);
  changed_.insert(uri);
  return nullptr;
}

Json Server::change(Json const& params) {
  auto& changed = document(params);
  auto text = changed.text;
  for (auto const& edit : params.at("contentChanges")) {
    auto const& inserted = edit.at("text").get_ref<std::string const&>();
    if (!edit.contains("range") || edit["range"].is_null()) {
      text = inserted;
      continue;
    }
    auto const begin = offset_of(text, position_in(edit["range"].at("start")), encoding_);
    auto const end = offset_of(text, position_in(edit["range"].at("end")), encoding_);
    text.replace(begin, std::max(begin, end) - begin, inserted);
  }
  bool const was_machine = may_be_machine(changed);
  std::erase_if(readings_, [&changed](auto const& reading) { return reading.second->depends_on(changed); });
  changed.text = std::move(text);
  changed.version = version_of(params.at("textDocument"));
  if (was_machine || may_be_machine(changed)) return check_all(params);
  changed_.insert(changed.uri);
  return nullptr;
}

Json Server::close(Json const& params) {
  auto const uri = params.at("textDocument").at("uri").get<std::string>();
  readings_.clear();
  if (documents_.erase(uri) == 0) return nullptr;
  closed_.insert(uri);
  published_.erase(uri);
  // What was not saved no longer counts.
  return check_all(params);
}

Json Server::check_all(Json const& /*params*/) {
  machines_.clear();
  readings_.clear();
  changed_.clear();
  for (auto const& [uri, document] : documents_) changed_.insert(uri);
  return nullptr;
}

std::string const& Server::machine_of(Document const& document) {
  auto const known = machines_.find(document.uri);
  if (known != machines_.end()) return known->second;
  Buffers files(documents_, surroundings_.disk);
  return machines_[document.uri] = editor::machine_of(files, document.path, surroundings_.options);
}

MachineReading& Server::reading_of(std::string const& machine) {
  auto& known = readings_[machine];
  if (!known) {
    known = std::make_unique<MachineReading>(documents_, surroundings_.disk, machine, surroundings_.options);
  }
  return *known;
}

}  // namespace axisc::editor
