#include "cli/files/output_file.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/fleet/unique_name.hpp"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;
constexpr mode_t permission_bits = 07777;

Text sentence(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return Text::ax9002_no_folder;
    case EISDIR:
      return Text::ax9002_is_folder;
    case EACCES:
    case EPERM:
      return Text::ax9002_no_permission;
    case EROFS:
      return Text::ax9002_read_only;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return Text::ax9002_no_space;
    case EPIPE:
      return Text::ax9002_closed_pipe;
    default:
      return Text::ax9002;
  }
}

/// Where a symbolic link leads, even if nothing is there yet.
std::string behind_links(std::string const& path) {
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < most_links && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    auto const next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

std::string folder_of(std::string const& path) {
  auto const folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Makes a file that was not there. A new target gets the usual mode from the system (asking for the mask would change it
/// for all threads); in the place of an old one nobody shall read more than before.
FileDescriptor make_file(std::string const& name, bool replaces) {
  return FileDescriptor(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? 0600 : 0666));
}

}  // namespace

OutputFile::TemporaryFile::~TemporaryFile() {
  if (!path.empty()) ::unlink(path.c_str());
}

OutputFile::OutputFile(std::string path, Durability durability)
    : path_(std::move(path)), durability_(durability) {
  if (path_ == "-") {
    file_ = FileDescriptor(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0));
    if (!file_.is_open()) fail(errno);
    return;
  }
  struct stat old {};
  bool const exists = ::stat(path_.c_str(), &old) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(old.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    open_directly(path_);
    return;
  }
  target_ = behind_links(path_);
  open_beside(exists, old.st_mode, old.st_uid, old.st_gid);
}

void OutputFile::open_directly(std::string const& path) {
  file_ = FileDescriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file_.is_open()) fail(errno);
}

void OutputFile::open_beside(bool exists, unsigned old_mode, unsigned old_user, unsigned old_group) {
  // Renaming needs no right to write the old file, but a write protection is meant.
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  std::string name = folder_of(target_) + "/.axisc-" + unique_name();
  {
    WithoutInterruption const made_and_remembered;
    file_ = make_file(name, exists);
    if (!file_.is_open()) fail(errno);
    temporary_.path = std::move(name);
    temporary_.interruption.emplace(temporary_.path.c_str());
  }
  if (!exists) return;
  // Only root may give a file away; the others keep their own name on it.
  [[maybe_unused]] bool const same_owner = ::fchown(file_.get(), old_user, old_group) == 0;
  if (::fchmod(file_.get(), old_mode & permission_bits) != 0) fail(errno);
}

void OutputFile::fail(int error) const {
  throw Failure(
      {.text = sentence(error), .arguments = {{"file", path_}, {"reason", system_error_text(error)}}},
      cannot_write);
}

void OutputFile::write(std::string_view bytes) {
  if (int const error = write_all(file_.get(), bytes); error != 0) fail(error);
}

void OutputFile::commit() {
  if (temporary_.path.empty()) {
    if (int const error = file_.close(); error != 0) fail(error);
    return;
  }
  bool const syncs = durability_ == Durability::of_content;
  if (syncs && ::fsync(file_.get()) != 0) fail(errno);
  if (int const error = file_.close(); error != 0) fail(error);
  if (::rename(temporary_.path.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.interruption.reset();
  temporary_.path.clear();
  if (!syncs) return;
  // The name survives a power failure only when its folder is synced too; the content is safe either way.
  FileDescriptor const folder(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) static_cast<void>(::fsync(folder.get()));
}

bool is_content_of(std::string const& path, std::string_view bytes) {
  if (path == "-") return false;
  FileDescriptor const file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat facts {};
  if (!file.is_open() || ::fstat(file.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) return false;
  if (static_cast<std::uint64_t>(facts.st_size) != bytes.size()) return false;
  std::string block(std::size_t{1} << 16U, '\0');
  while (!bytes.empty()) {
    auto const got = ::read(file.get(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    auto const length = static_cast<std::size_t>(got);
    if (bytes.substr(0, length) != std::string_view(block).substr(0, length)) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

void refuse_overwriting(std::string const& output, std::vector<std::string> const& sources) {
  for (auto const& source : sources) {
    std::error_code error;
    if (output != "-" && fs::equivalent(output, source, error)) {
      throw Failure({.text = Text::cli_output_is_input, .arguments = {{"file", output}}}, cannot_write);
    }
  }
}

}  // namespace axisc::cli
