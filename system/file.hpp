// Files, pipes and devices.
#pragma once

#include "system/error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::system {

enum class FileKind : std::uint8_t { regular, folder, link, other };

struct FileStatus {
  FileKind kind = FileKind::other;
  std::uint64_t size = 0;
  std::uint64_t device = 0;
  std::uint64_t inode = 0;  ///< with `device`: which file it is
  unsigned permissions = 0;
  unsigned user = 0;
  unsigned group = 0;
};

enum class Access : std::uint8_t {
  read,
  read_now,  ///< a pipe without a writer is not waited for
  write,
};

/// A symbolic link as the last component of a path.
enum class Link : std::uint8_t { followed, refused };

/// Who may read a new file.
enum class Privacy : std::uint8_t {
  usual,     ///< as the user's environment has it
  owner,     ///< its owner alone
  readable,  ///< everybody; only its owner may write
};

/// A file that is closed once. Calls that a signal interrupts are repeated.
class File {
 public:
  File() = default;
  File(File&& other) noexcept : handle_(std::exchange(other.handle_, none)) {}
  File& operator=(File&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  File(File const&) = delete;
  File& operator=(File const&) = delete;
  ~File();

  [[nodiscard]] static Result<File> open(std::string const& path, Access access, Link link = Link::followed);
  /// A file that was not there.
  [[nodiscard]] static Result<File> create(std::string const& path, Privacy privacy);
  [[nodiscard]] static Result<File> standard_input();
  [[nodiscard]] static Result<File> standard_output();

  [[nodiscard]] bool is_open() const { return handle_ != none; }
  [[nodiscard]] Result<FileStatus> status() const;

  /// A read would not wait: bytes are there, or the end. False where that is not known.
  [[nodiscard]] bool is_ready() const;
  /// Bytes that were read; 0 at the end.
  [[nodiscard]] Result<std::size_t> read(std::span<char> buffer) const;
  [[nodiscard]] Result<std::size_t> read_at(std::uint64_t offset, std::span<char> buffer) const;
  /// Writes all of `bytes`.
  [[nodiscard]] std::optional<Error> write(std::string_view bytes) const;
  /// Returns when the content is on the medium.
  [[nodiscard]] std::optional<Error> sync() const;
  /// Network file systems report a full disk only here.
  [[nodiscard]] std::optional<Error> close();

  /// Owner, group and permissions of `other`, as far as the user may set them.
  [[nodiscard]] std::optional<Error> take_over_owner(FileStatus const& other) const;
  /// Access control lists and other extended attributes of the file `path`. Best effort.
  void take_over_attributes(std::string const& path) const;

 private:
  static constexpr std::intptr_t none = -1;
  explicit File(std::intptr_t handle) : handle_(handle) {}

  std::intptr_t handle_ = none;
};

/// A file, not a folder, a pipe or a device.
[[nodiscard]] inline bool is_regular(File const& file) {
  auto const status = file.status();
  auto const* const facts = std::get_if<FileStatus>(&status);
  return facts != nullptr && facts->kind == FileKind::regular;
}
/// The status of the file that a link leads to, or of the link itself where links are refused.
[[nodiscard]] Result<FileStatus> status_of(std::string const& path, Link link = Link::followed);
/// Nothing where no file has this name.
[[nodiscard]] std::optional<FileKind> kind_of(std::string const& path, Link link = Link::followed);
/// Nothing where `path` may be written; it exists.
[[nodiscard]] std::optional<Error> refuses_writing(std::string const& path);
/// Puts `from` in the place of `to`, at once.
[[nodiscard]] std::optional<Error> replace(std::string const& from, std::string const& to);
/// Gives `from` the name `to`, at once, if nothing has it yet. The old name may stay, too.
[[nodiscard]] std::optional<Error> give_new_name(std::string const& from, std::string const& to);
/// Best effort.
void remove(std::string const& path);
/// The names in a folder survive a power failure. Best effort.
void sync_folder(std::string const& folder);
/// All of a file, whatever its reported size; nothing where it cannot be read.
[[nodiscard]] std::optional<std::string> bytes_of(std::string const& path);

}  // namespace axisc::system
