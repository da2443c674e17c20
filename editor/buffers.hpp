// Open documents take the place of the files on the disk.
#pragma once

#include "configuration/files.hpp"
#include "editor/server.hpp"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc::editor {

class Buffers final : public configuration::Files {
 public:
  Buffers(std::map<std::string, Document> const& documents, configuration::Files& disk) : disk_(disk) {
    for (auto const& [uri, document] : documents) texts_[document.path] = &document.text;
  }

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    auto const found = texts_.find(path);
    if (found == texts_.end()) return disk_.read(path);
    return *found->second;
  }
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override {
    return texts_.contains(path) ? Files::read_pieces(path, receive) : disk_.read_pieces(path, receive);
  }
  [[nodiscard]] bool is_file(std::string const& path) override {
    return texts_.contains(path) || disk_.is_file(path);
  }
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override {
    return disk_.names_in(folder);
  }
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override {
    return disk_.is_same(one, other);
  }

 private:
  configuration::Files& disk_;
  std::map<std::string, std::string const*> texts_;
};

}  // namespace axisc::editor
