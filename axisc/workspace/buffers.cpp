#include "axisc/workspace/buffers.hpp"

#include "axisc/workspace/uri.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>

namespace axisc {

OpenPaths::OpenPaths(OpenDocuments const& documents) {
  for (auto const& [uri, document] : documents) {
    by_path[document.path] = &document;
    std::string const name(validator::file_name(document.path));
    by_name.emplace(name, &document);
    names_in[document.path.substr(0, document.path.size() - name.size())].push_back(name);
  }
}

OpenDocument const* Buffers::document(std::string const& path) const {
  asked_.add(path);
  auto const found = open_->by_path.find(validator::key_of(path));
  if (found != open_->by_path.end()) return found->second;
  // Through a link to one of its folders. A link of another name is taken for a file of its own.
  auto const [first, last] = open_->by_name.equal_range(std::string(validator::file_name(path)));
  auto const same =
      std::find_if(first, last, [&](auto const& known) { return disk_.is_same(known.second->path, path); });
  return same == last ? nullptr : same->second;
}

std::string Buffers::uri(std::string const& path) const {
  auto const* const open = document(path);
  return open == nullptr ? uri_of(validator::key_of(path)) : open->uri;
}

std::variant<std::string, configuration::FileError> Buffers::read(std::string const& path) {
  auto const* const open = document(path);
  if (open == nullptr) return disk_.read(path);
  read_.insert(open);
  return open->text;
}

std::optional<configuration::FileError> Buffers::read_pieces(std::string const& path,
                                                             configuration::PieceReceiver const& receive) {
  auto const* const open = document(path);
  if (open == nullptr) return disk_.read_pieces(path, receive);
  read_.insert(open);
  receive(open->text);
  return std::nullopt;
}

bool Buffers::is_file(std::string const& path) {
  return document(path) != nullptr || disk_.is_file(path);
}

std::vector<std::string> Buffers::names_in(std::string const& folder) {
  asked_.add_folder(folder);
  auto names = disk_.names_in(folder);
  auto const open = open_->names_in.find(validator::key_of(folder));
  if (open == open_->names_in.end()) return names;
  std::set<std::string> known(names.begin(), names.end());
  for (auto const& name : open->second) {
    if (known.insert(name).second) names.push_back(name);
  }
  return names;
}

bool Buffers::is_same(std::string const& one, std::string const& other) {
  return validator::key_of(one) == validator::key_of(other) || disk_.is_same(one, other);
}

}  // namespace axisc
