#include "cli/files/disk_files.hpp"

#include "cli/codes.hpp"
#include "system/file.hpp"

#include <algorithm>
#include <span>

namespace axisc::cli {

namespace {

using configuration::FileError;

using Bytes = std::variant<std::string, FileError>;

constexpr std::size_t first_piece = std::size_t{1} << 16U;
constexpr std::size_t largest_piece = std::size_t{1} << 24U;
/// Of a file that is not kept: larger ones are no faster.
constexpr std::size_t block_size = std::size_t{1} << 16U;

FileError error_of(system::Error const& error) {
  switch (error.refusal) {
    case system::Refusal::not_found:
      return FileError::not_found;
    case system::Refusal::is_folder:
      return FileError::is_folder;
    case system::Refusal::no_permission:
      return FileError::no_permission;
    default:
      return FileError::not_readable;
  }
}

/// The end of the file decides, whatever size it is said to have. A byte more than that is asked for: a file that gives just
/// its size has come to its end, and need not be asked again.
Bytes read_all(system::File const& file, std::optional<std::size_t> size) {
  std::string bytes;
  std::size_t filled = 0;
  for (std::size_t piece = size.value_or(first_piece) + 1;;
       piece = std::clamp(filled, first_piece, largest_piece)) {
    bytes.resize(filled + piece);
    while (filled < bytes.size()) {
      auto const result = file.read(std::span(bytes).subspan(filled));
      if (auto const* const error = std::get_if<system::Error>(&result)) return error_of(*error);
      auto const got = std::get<std::size_t>(result);
      filled += got;
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
  system::File file;
  std::optional<std::size_t> size;  ///< none for a pipe
};

std::variant<OpenFile, FileError> open_file(std::string const& path) {
  auto opened = system::File::open(path, system::Access::read);
  if (auto const* const error = std::get_if<system::Error>(&opened)) return error_of(*error);
  OpenFile file{.file = std::get<system::File>(std::move(opened)), .size = {}};
  auto const status = file.file.status();
  if (std::holds_alternative<system::Error>(status)) return FileError::not_readable;
  auto const& facts = std::get<system::FileStatus>(status);
  if (facts.kind == system::FileKind::folder) return FileError::is_folder;
  if (facts.kind != system::FileKind::regular) return file;
  if (facts.size > configuration::largest_file) return FileError::too_large;
  file.size = static_cast<std::size_t>(facts.size);
  return file;
}

Bytes read_path(std::string const& path) {
  auto const opened = open_file(path);
  if (auto const* const error = std::get_if<FileError>(&opened)) return *error;
  auto const& file = std::get<OpenFile>(opened);
  return read_all(file.file, file.size);
}

std::optional<FileError> read_blocks(system::File const& file, configuration::PieceReceiver const& receive) {
  std::string block(block_size, '\0');
  while (true) {
    auto const result = file.read(block);
    if (auto const* const error = std::get_if<system::Error>(&result)) return error_of(*error);
    auto const got = std::get<std::size_t>(result);
    if (got == 0 || !receive(std::string_view(block).substr(0, got))) return {};
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
    auto const input = system::File::standard_input();
    if (auto const* const error = std::get_if<system::Error>(&input)) return error_of(*error);
    auto bytes = read_all(std::get<system::File>(input), std::nullopt);
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
    if (file.size) return read_blocks(file.file, receive);
    auto bytes = read_all(file.file, file.size);
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
