#include "editor/reading/open_machines.hpp"

#include "configuration/start_up_list.hpp"
#include "editor/reading/places.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

/// Its text may determine which files belong together.
bool may_be_machine(OpenDocument const& document) {
  return !is_list(document.path) ? !document.path.ends_with(".nc")
                                 : configuration::looks_like_start_up_list(document.text);
}

}  // namespace

OpenDocument const& OpenMachines::document(Json const& uri) const {
  return documents_.at(uri.get<std::string>());
}

OpenDocument const& OpenMachines::asked(Json const& params) const {
  return document(params.at("textDocument").at("uri"));
}

std::size_t OpenMachines::offset(OpenDocument const& document, Json const& params) const {
  return TextLines(document.text, client_.encoding).offset(position_in(params.at("position")));
}

Json OpenMachines::range(OpenDocument const& document, std::size_t begin, std::size_t end) const {
  return range_between(document.text, begin, end, client_.encoding);
}

OpenMachines::Uris OpenMachines::open(OpenDocument document) {
  auto const uri = document.uri;
  auto const& opened = documents_[uri] = std::move(document);
  open_paths_ = nullptr;
  machines_.erase(uri);
  forget_readings();
  // A machine may be missing this new file.
  bool const is_new = !disk_.is_file(opened.path);
  return may_be_machine(opened) || (is_new && readers_.know(opened.path)) ? forget() : Uris{uri};
}

OpenMachines::Uris OpenMachines::replace(OpenDocument const& document, std::string text,
                                         std::optional<std::int64_t> version) {
  auto& changed = documents_.at(document.uri);
  bool const was_machine = may_be_machine(changed);
  std::erase_if(readings_, [&](auto const& reading) {
    if (!reading.second->depends_on(changed)) return false;
    readers_.add(reading.first, reading.second->files().asked());
    return true;
  });
  changed.text = std::move(text);
  changed.version = version;
  return was_machine || may_be_machine(changed) ? forget() : Uris{changed.uri};
}

OpenMachines::Uris OpenMachines::close(std::string const& uri) {
  forget_readings();
  auto const closed = documents_.find(uri);
  if (closed == documents_.end()) return {};
  // Unsaved text no longer counts.
  bool const concerns_others = may_be_machine(closed->second) || readers_.know(closed->second.path);
  documents_.erase(closed);
  open_paths_ = nullptr;
  machines_.erase(uri);
  return concerns_others ? forget() : Uris();
}

OpenMachines::Uris OpenMachines::forget() {
  machines_.clear();
  search_.forget();
  readings_.clear();
  readers_.clear();
  Uris all;
  for (auto const& [uri, document] : documents_) all.insert(uri);
  return all;
}

void OpenMachines::forget_readings() {
  for (auto const& [machine, reading] : readings_) readers_.add(machine, reading->files().asked());
  search_.note_readers(readers_);
  readings_.clear();
  search_.forget();
}

Buffers OpenMachines::buffers() {
  if (!open_paths_) open_paths_ = std::make_shared<OpenPaths const>(documents_);
  return {open_paths_, disk_};
}

std::string const& OpenMachines::machine_of(OpenDocument const& document) {
  auto const known = machines_.find(document.uri);
  if (known != machines_.end()) return known->second;
  auto files = buffers();
  return machines_[document.uri] = search_.machine_of(files, document.path).machine;
}

MachineReading& OpenMachines::reading_of(std::string const& machine) {
  auto& known = readings_[machine];
  if (!known) known = std::make_unique<MachineReading>(buffers(), machine, options_);
  return *known;
}

}  // namespace axisc::editor
