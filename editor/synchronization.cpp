#include "axisc/workspace/uri.hpp"
#include "configuration/start_up_list.hpp"
#include "editor/reading/edited_text.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/requests.hpp"
#include "editor/server.hpp"
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
  open_paths_ = nullptr;
  closed_.erase(uri);
  machines_.erase(uri);
  forget_readings();
  // A new file may be one that a machine misses.
  bool const is_new = !surroundings_.disk.is_file(opened.path);
  if (may_be_machine(opened) || (is_new && readers_.know(opened.path))) return check_all(params);
  changed_.insert(uri);
  return nullptr;
}

Json Server::change(Json const& params) {
  auto& changed = document(params);
  EditedText text(changed.text, encoding_);
  for (auto const& edit : params.at("contentChanges")) {
    auto const& inserted = edit.at("text").get_ref<std::string const&>();
    if (!edit.contains("range") || edit["range"].is_null()) {
      text = EditedText(inserted, encoding_);
      continue;
    }
    auto const begin = text.offset(position_in(edit["range"].at("start")));
    auto const end = text.offset(position_in(edit["range"].at("end")));
    text.replace(begin, std::max(begin, end), inserted);
  }
  bool const was_machine = may_be_machine(changed);
  std::erase_if(readings_, [&](auto const& reading) {
    if (!reading.second->depends_on(changed)) return false;
    readers_.add(reading.first, reading.second->files().asked());
    return true;
  });
  changed.text = std::move(text).take();
  changed.version = version_of(params.at("textDocument"));
  if (was_machine || may_be_machine(changed)) return check_all(params);
  changed_.insert(changed.uri);
  return nullptr;
}

Json Server::close(Json const& params) {
  auto const uri = params.at("textDocument").at("uri").get<std::string>();
  forget_readings();
  auto const closed = documents_.find(uri);
  if (closed == documents_.end()) return nullptr;
  // What was not saved no longer counts.
  bool const concerns_others = may_be_machine(closed->second) || readers_.know(closed->second.path);
  documents_.erase(closed);
  open_paths_ = nullptr;
  machines_.erase(uri);
  changed_.erase(uri);
  closed_.insert(uri);
  published_.erase(uri);
  return concerns_others ? check_all(params) : nullptr;
}

Json Server::check_all(Json const& /*params*/) {
  machines_.clear();
  search_.forget();
  readings_.clear();
  readers_.clear();
  changed_.clear();
  for (auto const& [uri, document] : documents_) changed_.insert(uri);
  return nullptr;
}

std::string const& Server::machine_of(Document const& document) {
  auto const known = machines_.find(document.uri);
  if (known != machines_.end()) return known->second;
  auto files = buffers();
  return machines_[document.uri] = search_.machine_of(files, document.path).machine;
}

Buffers Server::buffers() {
  if (!open_paths_) open_paths_ = std::make_shared<OpenPaths const>(documents_);
  return {open_paths_, surroundings_.disk};
}

void Server::forget_readings() {
  for (auto const& [machine, reading] : readings_) readers_.add(machine, reading->files().asked());
  search_.note_readers(readers_);
  readings_.clear();
  search_.forget();
}

MachineReading& Server::reading_of(std::string const& machine) {
  auto& known = readings_[machine];
  if (!known) {
    known = std::make_unique<MachineReading>(buffers(), machine, surroundings_.options);
  }
  return *known;
}

}  // namespace axisc::editor
