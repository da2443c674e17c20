// Files with pending edits applied; all others come from the disk.
#pragma once

#include "configuration/files.hpp"

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
  /// Both must outlive this object.
  EditedFiles(EditedBytes const& edited, configuration::Files& disk) : edited_(edited), disk_(disk) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  [[nodiscard]] bool is_file(std::string const& path) override;
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override;
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override;

 private:
  /// A machine may spell the name differently.
  [[nodiscard]] EditedBytes::const_iterator find(std::string const& path) const;

  EditedBytes const& edited_;
  configuration::Files& disk_;
};

}  // namespace axisc
