// Digests of files; unchanged files are not read again.
//
// One table stores for each path (as a digest) device, inode, size, time of the last change of content and of the
// inode, in nanoseconds, and the digest. A file whose facts are equal is not read. A file that changed within two
// seconds before it was read is not put into the table: another change within the resolution of the clock would go
// unnoticed. Programs cannot set the time of the inode's change, so restoring the time of the content does not hide a
// change.
#pragma once

#include "cli/fleet/digest.hpp"
#include "configuration/files.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

/// Facts about a file that are known without reading it.
struct FileFacts {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t changed = 0;        ///< its content, in nanoseconds since 1970
  std::int64_t inode_changed = 0;  ///< its content, name, owner or mode
  friend bool operator==(FileFacts const&, FileFacts const&) = default;
};

/// None if the file is missing or not a regular file.
[[nodiscard]] std::optional<FileFacts> facts_of(std::string const& path);
[[nodiscard]] std::int64_t nanoseconds_now();

/// The content of a file, or why it cannot be read.
struct FileState {
  Digest digest;
  std::optional<configuration::FileError> error;
  friend bool operator==(FileState const&, FileState const&) = default;
};

/// May be used by several threads.
class FileDigests {
 public:
  /// Reads the table. A table that is missing, damaged or of another version counts as empty.
  explicit FileDigests(std::string table);

  /// Looks up a file by its facts, without reading it.
  [[nodiscard]] std::optional<Digest> known(std::string const& path, FileFacts const& facts);
  /// Stores the digest of `path`. `facts` were the same before and after reading it, which began at `begun`.
  void learn(std::string const& path, FileFacts const& facts, std::int64_t begun, Digest const& digest);
  /// Failure (AX9002) if the table cannot be written. If two processes save at once, the later one wins.
  void save();

  struct Row {
    Digest path;
    FileFacts facts;
    Digest digest;
    std::int64_t seen = 0;  ///< when it was last asked for, in nanoseconds, roughly
  };

 private:
  [[nodiscard]] Digest key_of(std::string const& path) const;

  std::string table_;
  std::string working_folder_;
  std::vector<Row> rows_;  ///< by path
  std::mutex mutex_;
  std::vector<Row> learned_;
};

}  // namespace axisc::cli
