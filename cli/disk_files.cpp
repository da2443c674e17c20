#include "cli/disk_files.hpp"

#include "cli/codes.hpp"
#include "cli/file_descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axisc::cli {

namespace {

using validator::FileError;

using Bytes = std::variant<std::string, FileError>;

constexpr std::size_t first_piece = std::size_t{1} << 16U;
constexpr std::size_t largest_piece = std::size_t{1} << 24U;

FileError error_of(int number) {
  switch (number) {
    case ENOENT:
    case ENOTDIR:
      return FileError::not_found;
    case EISDIR:
      return FileError::is_folder;
    case EACCES:
    case EPERM:
      return FileError::no_permission;
    default:
      return FileError::not_readable;
  }
}

/// `expected` bytes at least are reserved; the end of the file decides.
Bytes read_descriptor(int descriptor, std::size_t expected) {
  std::string bytes;
  std::size_t filled = 0;
  for (std::size_t piece = expected + 1;; piece = std::clamp(filled, first_piece, largest_piece)) {
    bytes.resize(filled + piece);
    while (filled < bytes.size()) {
      auto const got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return error_of(errno);
      if (got == 0) {
        bytes.resize(filled);
        return bytes;
      }
      filled += static_cast<std::size_t>(got);
      if (filled > validator::largest_file) return FileError::too_large;
    }
  }
}

Bytes read_path(std::string const& path) {
  FileDescriptor const file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return error_of(errno);
  struct stat facts {};
  if (::fstat(file.get(), &facts) != 0) return FileError::not_readable;
  if (S_ISDIR(facts.st_mode)) return FileError::is_folder;
  if (!S_ISREG(facts.st_mode)) return read_descriptor(file.get(), first_piece);
  auto const size = static_cast<std::uint64_t>(facts.st_size);
  if (size > validator::largest_file) return FileError::too_large;
  return read_descriptor(file.get(), static_cast<std::size_t>(size));
}

Text sentence(FileError error) {
  switch (error) {
    case FileError::not_found:
      return Text::ax9001_not_found;
    case FileError::is_folder:
      return Text::ax9001_is_folder;
    case FileError::no_permission:
      return Text::ax9001_no_permission;
    case FileError::not_readable:
      return Text::ax9001_not_readable;
    case FileError::too_large:
      return Text::ax9003;
    case FileError::line_too_long:
      return Text::ax9003_line;
    case FileError::binary:
      return Text::ax9001_binary;
    case FileError::utf16:
      return Text::ax9001_utf16;
    case FileError::image:
      return Text::ax9001_image;
  }
  return Text::ax9001_not_readable;
}

}  // namespace

Bytes DiskFiles::read(std::string const& path) {
  if (!dash_is_standard_input_ || path != "-") return read_path(path);
  if (!standard_input_) {
    auto bytes = read_descriptor(STDIN_FILENO, first_piece);
    if (std::holds_alternative<FileError>(bytes)) return bytes;
    standard_input_ = std::get<std::string>(std::move(bytes));
  }
  return *standard_input_;
}

Failure unreadable(std::string const& path, FileError error) {
  bool const large = error == FileError::too_large || error == FileError::line_too_long;
  return Failure({.text = sentence(error), .arguments = {{"file", path}}}, large ? too_large : cannot_read);
}

}  // namespace axisc::cli
