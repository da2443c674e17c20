// Reads files from the disk and records the names and digests of all files that a result depends on.
#pragma once

#include "cli/files/disk_files.hpp"
#include "cli/fleet/file_digests.hpp"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc::cli {

/// Digests of the files that a result depends on, by path. Includes files that were looked up but do not exist.
using Dependencies = std::map<std::string, FileState>;

class RecordedFiles final : public configuration::Files {
 public:
  /// If `digests` is null, every file is read for its digest.
  explicit RecordedFiles(FileDigests* digests) : digests_(digests) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  /// Not recorded: a result that depends on a folder is not complete.
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override {
    complete_ = false;
    return disk_.names_in(folder);
  }
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override {
    return disk_.is_same(one, other);
  }

  /// State of a file: from the table if it has not changed, otherwise it is read. A file that is not too large is kept,
  /// so that read() does not read it again.
  [[nodiscard]] FileState state_of(std::string const& path);

  [[nodiscard]] Dependencies const& dependencies() const { return dependencies_; }
  /// True if everything that was read is in the record and nothing changed meanwhile.
  [[nodiscard]] bool is_complete() const { return complete_; }

 private:
  void record(std::string const& path, FileState const& state);
  /// Hashes a file that is read in pieces, and stores the digest if the file did not change meanwhile.
  class Reading;

  FileDigests* digests_;
  DiskFiles disk_;
  std::map<std::string, std::string> kept_;
  Dependencies dependencies_;
  bool complete_ = true;
};

}  // namespace axisc::cli
