#include "cli/files/disk_files.hpp"

#include "cli/codes.hpp"
#include "system/file.hpp"

#include <algorithm>
#include <span>

namespace axisc::cli::says {

constexpr Sentence cannot_read_not_found{
    "cannot read {file}: there is no such file; check the name and the folder",
    "{file} ist nicht lesbar: die Datei gibt es nicht; Name und Ordner prüfen"};
constexpr Sentence cannot_read_is_folder{
    "cannot read {file}: it is a folder; name a file in it",
    "{file} ist nicht lesbar: es ist ein Ordner; eine Datei darin angeben"};
constexpr Sentence cannot_read_no_permission{
    "cannot read {file}: permission denied; check its access rights",
    "{file} ist nicht lesbar: keine Berechtigung; die Zugriffsrechte prüfen"};
constexpr Sentence cannot_read_not_readable{
    "cannot read {file}: the system reports a read error; check the medium or the connection",
    "{file} ist nicht lesbar: das System meldet einen Lesefehler; Datenträger oder Verbindung prüfen"};
constexpr Sentence cannot_read_binary{
    "cannot read {file}: it is a binary file, not text; name an axis list or a machine file",
    "{file} ist nicht lesbar: es ist eine Binärdatei, kein Text; eine Achsliste oder Maschinendatei angeben"};
constexpr Sentence cannot_read_utf16{
    "cannot read {file}: it is UTF-16; save it as UTF-8 or windows-1252",
    "{file} ist nicht lesbar: es ist UTF-16; als UTF-8 oder windows-1252 speichern"};
constexpr Sentence cannot_read_image{
    "cannot read {file} as a list: it is a coefficient image; give the list or machine file that it was "
    "compiled from, or look into it with `axisc inspect`",
    "{file} ist nicht als Liste lesbar: es ist ein Koeffizientenabbild; die Liste oder Maschinendatei "
    "angeben, "
    "aus der es entstand, oder mit `axisc inspect` ansehen"};

constexpr Sentence too_large{
    "cannot read {file}: it is larger than 1 GiB; an axis list has a few thousand lines",
    "{file} ist nicht lesbar: die Datei ist größer als 1 GiB; eine Achsliste hat einige tausend Zeilen"};
constexpr Sentence too_large_line{
    "cannot read {file}: a line is longer than 1 MiB; an axis list has one parameter per line",
    "{file} ist nicht lesbar: eine Zeile ist länger als 1 MiB; eine Achsliste hat einen Parameter je Zeile"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

using configuration::FileError;

using Bytes = std::variant<std::string, FileError>;

constexpr std::size_t first_piece = std::size_t{1} << 16U;
constexpr std::size_t largest_piece = std::size_t{1} << 24U;
/// Block size for a file that is not kept in memory: larger blocks are not faster.
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

/// Reads to the end of the file, whatever its reported size. One byte more than the size is requested, so that a file
/// of just that size needs no second call.
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

SentenceRef sentence(FileError error) {
  switch (error) {
    case FileError::not_found:
      return says::cannot_read_not_found;
    case FileError::is_folder:
      return says::cannot_read_is_folder;
    case FileError::no_permission:
      return says::cannot_read_no_permission;
    case FileError::not_readable:
      return says::cannot_read_not_readable;
    case FileError::too_large:
      return says::too_large;
    case FileError::line_too_long:
      return says::too_large_line;
    case FileError::binary:
      return says::cannot_read_binary;
    case FileError::utf16:
      return says::cannot_read_utf16;
    case FileError::image:
      return says::cannot_read_image;
  }
  return says::cannot_read_not_readable;
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
  return Failure({.sentence = sentence(error), .arguments = {{"file", path}}},
                 large ? too_large : cannot_read);
}

std::string read_whole(std::string const& path, Dash dash) {
  DiskFiles files(dash == Dash::is_standard_input && path == "-");
  auto bytes = files.read(path);
  if (auto const* const error = std::get_if<FileError>(&bytes)) throw unreadable(path, *error);
  return std::get<std::string>(std::move(bytes));
}

}  // namespace axisc::cli
