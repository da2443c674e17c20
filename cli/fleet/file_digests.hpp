// Digests of files, without reading a file again that has not changed since.
//
// What is known stands in one table: for each path (as a digest) device, inode, size, time of the last change of content
// and of the inode, in nanoseconds, and the digest. A file whose facts are equal is not read. A file that changed within
// two seconds before it was read is not put into the table: it could change once more within the resolution of its
// clock, and nobody would see it. The time of the inode's change cannot be set by programs, so a restored time of
// content deceives nobody.
#pragma once

#include "cli/fleet/digest.hpp"
#include "configuration/files.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

/// What can be seen of a file without reading it.
struct FileFacts {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t changed = 0;        ///< its content, in nanoseconds since 1970
  std::int64_t inode_changed = 0;  ///< its content, name, owner or mode
  friend bool operator==(FileFacts const&, FileFacts const&) = default;
};

/// None for what is no regular file, or not there.
[[nodiscard]] std::optional<FileFacts> facts_of(std::string const& path);
[[nodiscard]] std::int64_t nanoseconds_now();

/// The content of a file, or why there is none.
struct FileState {
  Digest digest;
  std::optional<configuration::FileError> error;
  friend bool operator==(FileState const&, FileState const&) = default;
};

/// May be used by several threads.
class FileDigests {
 public:
  /// Reads the table. One that is missing, damaged or of another version counts as empty.
  explicit FileDigests(std::string table);

  /// By its facts alone.
  [[nodiscard]] std::optional<Digest> known(std::string const& path, FileFacts const& facts);
  /// `facts` are those before and after `path` was read, which was begun at `begun`.
  void learn(std::string const& path, FileFacts const& facts, std::int64_t begun, Digest const& digest);
  /// Failure (AX9002) where the table cannot be written. Of two processes that save at once, the later one wins.
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
