// The disk, and a record of what was read from it: the names and digests of all files that a result depends on.
#pragma once

#include "cli/files/disk_files.hpp"
#include "cli/fleet/file_digests.hpp"

#include <map>
#include <optional>
#include <string>
#include <variant>

namespace axisc::cli {

/// What a result depends on, by path. Files that were looked for and are not there count too.
using Dependencies = std::map<std::string, FileState>;

class RecordedFiles final : public configuration::Files {
 public:
  /// `digests` may be null: then every file is read for its digest.
  explicit RecordedFiles(FileDigests* digests) : digests_(digests) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;

  /// State of a file: from the table where it has not changed, else it is read. A file that is not too large is kept and
  /// not read again by read(). None for what is no regular file: a pipe gives its bytes once.
  [[nodiscard]] std::optional<FileState> state_of(std::string const& path);

  [[nodiscard]] Dependencies const& dependencies() const { return dependencies_; }
  /// Everything that was read is in the record, and nothing changed meanwhile.
  [[nodiscard]] bool is_complete() const { return complete_; }

 private:
  void record(std::string const& path, FileState const& state);
  /// Hashes a file that is read in pieces, and remembers the digest where the file did not change meanwhile.
  class Reading;

  FileDigests* digests_;
  DiskFiles disk_;
  std::map<std::string, std::string> kept_;
  Dependencies dependencies_;
  bool complete_ = true;
};

}  // namespace axisc::cli
