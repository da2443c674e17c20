// Files with pending edits applied; all others come from the disk.
#pragma once

#include "axisc/files/disk_files.hpp"
#include "validator/loading/loader.hpp"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc {

/// New bytes by path.
using EditedBytes = std::map<std::string, std::string>;

/// Reads the edited bytes if there are any. Several readers may share one map while it is not changed.
class EditedFiles final : public configuration::Files {
 public:
  EditedFiles(EditedBytes const& edited, bool dash_is_standard_input)
      : edited_(edited), disk_(dash_is_standard_input) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    auto const found = find(path);
    return found == edited_.end() ? disk_.read(path) : found->second;
  }

  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override {
    return find(path) != edited_.end() ? Files::read_pieces(path, receive) : disk_.read_pieces(path, receive);
  }

  [[nodiscard]] bool is_file(std::string const& path) override {
    return find(path) != edited_.end() || disk_.is_file(path);
  }
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override {
    return disk_.names_in(folder);
  }
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override {
    return disk_.is_same(one, other);
  }

 private:
  /// A machine may spell the name differently.
  [[nodiscard]] EditedBytes::const_iterator find(std::string const& path) const {
    auto const found = edited_.find(path);
    return found == edited_.end() && !edited_.empty() ? edited_.find(validator::key_of(path)) : found;
  }

  EditedBytes const& edited_;
  DiskFiles disk_;
};

}  // namespace axisc
