// A file that is either written completely or not at all.
#pragma once

#include "system/file.hpp"
#include "system/interruption.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace axisc {

/// Writes to a temporary file next to the target, syncs and renames, so that no reader sees a partial file
/// and an existing file is unchanged if anything fails or the program is interrupted. A symbolic link is
/// followed, the old file's mode kept. A target that is not a regular file (a device, a pipe) is opened and
/// written directly, never renamed over; "-" is standard output. Every function may throw a Failure (AX9002).
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  OutputFile(OutputFile const&) = delete;
  OutputFile& operator=(OutputFile const&) = delete;
  ~OutputFile() = default;

  void write(std::string_view bytes);
  /// Moves the file to its final name. Nothing can be written afterwards.
  void commit();
  /// Moves the file to its final name if the old file still has the content `before`; a Failure otherwise.
  void commit_over(std::string_view before);

 private:
  /// Removed with this object, or when the program is interrupted, unless it has been renamed.
  struct TemporaryFile {
    std::string path;  ///< empty where there is none (any more)
    std::optional<system::RemovedWhenInterrupted> interruption;
    TemporaryFile() = default;
    TemporaryFile(TemporaryFile const&) = delete;
    TemporaryFile& operator=(TemporaryFile const&) = delete;
    ~TemporaryFile();
  };

  void take(system::Result<system::File> opened);
  void open_beside(system::FileStatus const* old);
  /// `before` may be null.
  void finish(std::string_view const* before);
  [[noreturn]] void fail(system::Error const& error) const;
  void require(std::optional<system::Error> const& error) const;

  std::string path_;    ///< as the user wrote it
  std::string target_;  ///< with symbolic links resolved; empty when written directly
  TemporaryFile temporary_;
  system::File file_;
};

/// True if `path` is a regular file with exactly these bytes: writing it again would only change its time.
[[nodiscard]] bool is_content_of(std::string const& path, std::string_view bytes);

/// Replaces a file whose content was `before` when it was read. Failure if it was changed meanwhile: changes
/// by another program are not lost.
void replace_content(std::string const& path, std::string_view before, std::string_view after);

/// Makes a folder, and those above it, where there is none. Failure (AX9002) with the system's reason.
void make_folder(std::filesystem::path const& folder);

}  // namespace axisc
