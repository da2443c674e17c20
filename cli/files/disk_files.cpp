#include "cli/files/disk_files.hpp"

#include "cli/codes.hpp"
#include "cli/files/file_descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axisc::cli {

namespace {

using configuration::FileError;

using Bytes = std::variant<std::string, FileError>;

constexpr std::size_t first_piece = std::size_t{1} << 16U;
constexpr std::size_t largest_piece = std::size_t{1} << 24U;
/// Of a file that is not kept: larger ones are no faster.
constexpr std::size_t block_size = std::size_t{1} << 16U;

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

/// The end of the file decides, whatever size it is said to have. A byte more than that is asked for: whoever gives just
/// the size has come to the end, and need not be asked again.
Bytes read_descriptor(int descriptor, std::optional<std::size_t> size) {
  std::string bytes;
  std::size_t filled = 0;
  for (std::size_t piece = size.value_or(first_piece) + 1;;
       piece = std::clamp(filled, first_piece, largest_piece)) {
    bytes.resize(filled + piece);
    while (filled < bytes.size()) {
      auto const got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return error_of(errno);
      filled += static_cast<std::size_t>(got);
      if (filled > configuration::largest_file) return FileError::too_large;
      if (got == 0 || filled == size) {
        bytes.resize(filled);
        return bytes;
      }
    }
  }
}

/// A file that is open, and its size where it has one.
struct OpenFile {
  FileDescriptor descriptor;
  std::optional<std::size_t> size;  ///< none for a pipe
};

std::variant<OpenFile, FileError> open_file(std::string const& path) {
  OpenFile file{.descriptor = FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), .size = {}};
  if (!file.descriptor.is_open()) return error_of(errno);
  struct stat facts {};
  if (::fstat(file.descriptor.get(), &facts) != 0) return FileError::not_readable;
  if (S_ISDIR(facts.st_mode)) return FileError::is_folder;
  if (!S_ISREG(facts.st_mode)) return file;
  auto const size = static_cast<std::uint64_t>(facts.st_size);
  if (size > configuration::largest_file) return FileError::too_large;
  file.size = static_cast<std::size_t>(size);
  return file;
}

Bytes read_file(OpenFile const& file) {
  return read_descriptor(file.descriptor.get(), file.size);
}

Bytes read_path(std::string const& path) {
  auto const file = open_file(path);
  if (auto const* const error = std::get_if<FileError>(&file)) return *error;
  return read_file(std::get<OpenFile>(file));
}

std::optional<FileError> read_blocks(int descriptor, configuration::PieceReceiver const& receive) {
  std::string block(block_size, '\0');
  while (true) {
    auto const got = ::read(descriptor, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return error_of(errno);
    if (got == 0 || !receive(std::string_view(block).substr(0, static_cast<std::size_t>(got)))) return {};
  }
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
    auto bytes = read_descriptor(STDIN_FILENO, std::nullopt);
    if (std::holds_alternative<FileError>(bytes)) return bytes;
    standard_input_ = std::get<std::string>(std::move(bytes));
  }
  return *standard_input_;
}

std::optional<FileError> DiskFiles::read_pieces(std::string const& path,
                                                configuration::PieceReceiver const& receive) {
  if (dash_is_standard_input_ && path == "-") return Files::read_pieces(path, receive);
  auto held = pipes_.find(path);
  if (held == pipes_.end()) {
    auto const opened = open_file(path);
    if (auto const* const error = std::get_if<FileError>(&opened)) return *error;
    auto const& file = std::get<OpenFile>(opened);
    if (file.size) return read_blocks(file.descriptor.get(), receive);
    auto bytes = read_file(file);
    if (auto const* const error = std::get_if<FileError>(&bytes)) return *error;
    held = pipes_.emplace(path, std::get<std::string>(std::move(bytes))).first;
  }
  receive(held->second);
  return std::nullopt;
}

Failure unreadable(std::string const& path, FileError error) {
  bool const large = error == FileError::too_large || error == FileError::line_too_long;
  return Failure({.text = sentence(error), .arguments = {{"file", path}}}, large ? too_large : cannot_read);
}

std::string read_whole(std::string const& path, Dash dash) {
  DiskFiles files(dash == Dash::is_standard_input && path == "-");
  auto bytes = files.read(path);
  if (auto const* const error = std::get_if<FileError>(&bytes)) throw unreadable(path, *error);
  return std::get<std::string>(std::move(bytes));
}

}  // namespace axisc::cli
