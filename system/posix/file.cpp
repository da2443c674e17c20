#include "system/file.hpp"

#include "system/posix/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__linux__)
#include <linux/magic.h>
#include <sys/vfs.h>
#include <sys/xattr.h>
#endif

namespace axisc::system {
namespace {

constexpr mode_t permission_bits = 07777;

int descriptor(std::intptr_t handle) {
  return static_cast<int>(handle);
}

FileStatus status_from(struct stat const& facts) {
  return {.kind = S_ISREG(facts.st_mode)   ? FileKind::regular
                  : S_ISDIR(facts.st_mode) ? FileKind::folder
                  : S_ISLNK(facts.st_mode) ? FileKind::link
                                           : FileKind::other,
          .size = static_cast<std::uint64_t>(facts.st_size),
          .device = facts.st_dev,
          .inode = facts.st_ino,
          .permissions = facts.st_mode & permission_bits,
          .user = facts.st_uid,
          .group = facts.st_gid};
}

/// Files of /proc, /sys and their like describe processes and devices, whatever names and links lead to them.
bool is_of_kernel([[maybe_unused]] int file) {
#if defined(__linux__)
  constexpr std::array<std::uint32_t, 12> file_systems = {
      PROC_SUPER_MAGIC,   SYSFS_MAGIC,         DEBUGFS_MAGIC, TRACEFS_MAGIC,  SECURITYFS_MAGIC, SELINUX_MAGIC,
      CGROUP_SUPER_MAGIC, CGROUP2_SUPER_MAGIC, SMACK_MAGIC,   PSTOREFS_MAGIC, EFIVARFS_MAGIC,   BPF_FS_MAGIC};
  struct statfs facts {};
  if (::fstatfs(file, &facts) != 0) return false;
  auto const type = static_cast<std::uint32_t>(facts.f_type);
  return std::find(file_systems.begin(), file_systems.end(), type) != file_systems.end();
#else
  return false;
#endif
}

int flags_of(Access access) {
  switch (access) {
    case Access::read: return O_RDONLY;
    case Access::read_now: return O_RDONLY | O_NONBLOCK;
    case Access::write: return O_WRONLY;
  }
  return O_RDONLY;
}

mode_t mode_of(Privacy privacy) {
  switch (privacy) {
    case Privacy::usual: return 0666;
    case Privacy::owner: return 0600;
    case Privacy::readable: return 0644;
  }
  return 0600;
}

/// Repeats a call of the system that a signal interrupted.
template <typename Call>
ssize_t repeated(Call call) {
  while (true) {
    ssize_t const result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

Result<std::size_t> count_or_error(ssize_t count) {
  if (count < 0) return last_error();
  return static_cast<std::size_t>(count);
}

std::optional<Error> error_unless(bool good) {
  return good ? std::nullopt : std::optional(last_error());
}

}  // namespace

File::~File() {
  if (is_open()) ::close(descriptor(handle_));
}

Result<File> File::open(std::string const& path, Access access, Link link) {
  int const links = link == Link::refused ? O_NOFOLLOW : 0;
  int const opened = ::open(path.c_str(), flags_of(access) | links | O_CLOEXEC | O_NOCTTY);
  if (opened < 0) return last_error();
  return File(opened);
}

Result<File> File::create(std::string const& path, Privacy privacy) {
  // The usual mode comes from the system: asking for the mask would change it for all threads.
  int const opened = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode_of(privacy));
  if (opened < 0) return last_error();
  return File(opened);
}

Result<File> File::standard_input() {
  int const copied = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
  if (copied < 0) return last_error();
  return File(copied);
}

Result<File> File::standard_output() {
  int const copied = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  if (copied < 0) return last_error();
  return File(copied);
}

Result<FileStatus> File::status() const {
  struct stat facts {};
  if (::fstat(descriptor(handle_), &facts) != 0) return last_error();
  FileStatus status = status_from(facts);
  if (status.kind == FileKind::regular && is_of_kernel(descriptor(handle_))) status.kind = FileKind::other;
  return status;
}

bool File::is_ready() const {
  pollfd asked{.fd = descriptor(handle_), .events = POLLIN, .revents = 0};
  return ::poll(&asked, 1, 0) > 0;
}

Result<std::size_t> File::read(std::span<char> buffer) const {
  return count_or_error(repeated([&] { return ::read(descriptor(handle_), buffer.data(), buffer.size()); }));
}

Result<std::size_t> File::read_at(std::uint64_t offset, std::span<char> buffer) const {
  return count_or_error(repeated([&] {
    return ::pread(descriptor(handle_), buffer.data(), buffer.size(), static_cast<off_t>(offset));
  }));
}

std::optional<Error> File::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    ssize_t const written =
        repeated([&] { return ::write(descriptor(handle_), bytes.data(), bytes.size()); });
    if (written < 0) return last_error();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return std::nullopt;
}

std::optional<Error> File::sync() const {
  return error_unless(::fsync(descriptor(handle_)) == 0);
}

std::optional<Error> File::close() {
  if (!is_open()) return std::nullopt;
  return error_unless(::close(descriptor(std::exchange(handle_, none))) == 0);
}

std::optional<Error> File::take_over_owner(FileStatus const& other) const {
  int const file = descriptor(handle_);
  // Only root may give a file away; other users remain its owner, and can set the group if they belong to it.
  bool const is_given = ::fchown(file, other.user, other.group) == 0;
  if (!is_given) {
    [[maybe_unused]] bool const has_group = ::fchown(file, static_cast<uid_t>(-1), other.group) == 0;
  }
  return error_unless(::fchmod(file, other.permissions) == 0);
}

void File::take_over_attributes(std::string const& path) const {
#if defined(__linux__)
  auto const size_of = [](ssize_t size) {
    return size < 0 ? std::size_t{0} : static_cast<std::size_t>(size);
  };
  std::string names(size_of(::listxattr(path.c_str(), nullptr, 0)), '\0');
  names.resize(size_of(::listxattr(path.c_str(), names.data(), names.size())));
  for (std::size_t at = 0; at < names.size(); at = names.find('\0', at) + 1) {
    char const* const name = names.data() + at;
    std::string value(size_of(::getxattr(path.c_str(), name, nullptr, 0)), '\0');
    value.resize(size_of(::getxattr(path.c_str(), name, value.data(), value.size())));
    static_cast<void>(::fsetxattr(descriptor(handle_), name, value.data(), value.size(), 0));
  }
#else
  static_cast<void>(path);
#endif
}

Result<FileStatus> status_of(std::string const& path, Link link) {
  struct stat facts {};
  int const failed = link == Link::followed ? ::stat(path.c_str(), &facts) : ::lstat(path.c_str(), &facts);
  if (failed != 0) return last_error();
  return status_from(facts);
}

std::optional<Error> refuses_writing(std::string const& path) {
  return error_unless(::access(path.c_str(), W_OK) == 0);
}

std::optional<Error> replace(std::string const& from, std::string const& to) {
  return error_unless(::rename(from.c_str(), to.c_str()) == 0);
}

std::optional<Error> give_new_name(std::string const& from, std::string const& to) {
  if (::link(from.c_str(), to.c_str()) == 0) return std::nullopt;
  // Some file systems know no links.
  bool const has_links = errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS;
  if (has_links) return last_error();
  struct stat facts {};
  if (::lstat(to.c_str(), &facts) == 0) return error_of(EEXIST);
  return replace(from, to);
}

void remove(std::string const& path) {
  ::unlink(path.c_str());
}

void sync_folder(std::string const& folder) {
  int const opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  static_cast<void>(::fsync(opened));
  ::close(opened);
}

}  // namespace axisc::system
