#include "axisc/files/disk_files.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/sentences.hpp"
#include "system/file.hpp"
#include "system/folder.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <system_error>

namespace axisc::says {

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
    "angeben, aus der es entstand, oder mit `axisc inspect` ansehen"};

constexpr Sentence cannot_read_not_regular{
    "cannot read {file}: it is a pipe, a device or a file of /proc or /sys, not a regular file; use - for "
    "standard input",
    "{file} ist nicht lesbar: eine Pipe, ein Gerät oder eine Datei aus /proc oder /sys, keine gewöhnliche "
    "Datei; - ist die Standardeingabe"};
constexpr Sentence cannot_read_link_loop{"cannot read {file}: its symbolic links lead in a circle",
                                         "{file} ist nicht lesbar: ihre symbolischen Links führen im Kreis"};

constexpr Sentence too_large{
    "cannot read {file}: it is larger than 1 GiB; an axis list has a few thousand lines",
    "{file} ist nicht lesbar: die Datei ist größer als 1 GiB; eine Achsliste hat einige tausend Zeilen"};
constexpr Sentence too_large_line{
    "cannot read {file}: a line is longer than 1 MiB; break it into shorter lines",
    "{file} ist nicht lesbar: eine Zeile ist länger als 1 MiB; sie in kürzere Zeilen teilen"};

}  // namespace axisc::says

namespace axisc {

namespace {

using configuration::FileError;

using Bytes = std::variant<std::string, FileError>;

constexpr std::size_t first_piece = std::size_t{1} << 16U;
constexpr std::size_t largest_piece = std::size_t{1} << 24U;
/// Block size for a file that is not kept in memory: larger blocks are not faster.
constexpr std::size_t block_size = std::size_t{1} << 16U;

FileError error_of(system::Error const& error) {
  switch (error.refusal) {
    case system::Refusal::not_found: return FileError::not_found;
    case system::Refusal::is_folder: return FileError::is_folder;
    case system::Refusal::no_permission: return FileError::no_permission;
    case system::Refusal::link_loop: return FileError::link_loop;
    default: return FileError::not_readable;
  }
}

/// Reads to the end of the file, whatever its reported size. One byte more than the size is requested, so
/// that a file of just that size needs no second call.
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

enum class Pipes : std::uint8_t { refused, read };

std::variant<OpenFile, FileError> open_file(std::string const& path, Pipes pipes) {
  bool const waits = pipes == Pipes::read;
  auto opened = system::File::open(path, waits ? system::Access::read : system::Access::read_now);
  if (auto const* const error = std::get_if<system::Error>(&opened)) return error_of(*error);
  OpenFile file{.file = std::get<system::File>(std::move(opened)), .size = {}};
  auto const status = file.file.status();
  if (std::holds_alternative<system::Error>(status)) return FileError::not_readable;
  auto const& facts = std::get<system::FileStatus>(status);
  if (facts.kind == system::FileKind::folder) return FileError::is_folder;
  if (facts.kind != system::FileKind::regular) {
    if (!waits) return FileError::not_regular;
    return file;
  }
  if (facts.size > configuration::largest_file) return FileError::too_large;
  file.size = static_cast<std::size_t>(facts.size);
  return file;
}

Bytes read_path(std::string const& path, Pipes pipes) {
  auto const opened = open_file(path, pipes);
  if (auto const* const error = std::get_if<FileError>(&opened)) return *error;
  auto const& file = std::get<OpenFile>(opened);
  return read_all(file.file, file.size);
}

std::string require(std::string const& path, Bytes bytes) {
  if (auto const* const error = std::get_if<FileError>(&bytes)) throw unreadable(path, *error);
  return std::get<std::string>(std::move(bytes));
}

std::optional<FileError> read_blocks(system::File const& file, configuration::PieceReceiver const& receive) {
  auto const memory = std::make_unique_for_overwrite<char[]>(block_size);
  std::span<char> const block(memory.get(), block_size);
  while (true) {
    auto const result = file.read(block);
    if (auto const* const error = std::get_if<system::Error>(&result)) return error_of(*error);
    auto const got = std::get<std::size_t>(result);
    if (got == 0 || !receive(std::string_view(block.data(), got))) return {};
  }
}

SentenceRef sentence(FileError error) {
  switch (error) {
    case FileError::not_found: return says::cannot_read_not_found;
    case FileError::is_folder: return says::cannot_read_is_folder;
    case FileError::no_permission: return says::cannot_read_no_permission;
    case FileError::not_readable: return says::cannot_read_not_readable;
    case FileError::too_large: return says::too_large;
    case FileError::line_too_long: return says::too_large_line;
    case FileError::binary: return says::cannot_read_binary;
    case FileError::utf16: return says::cannot_read_utf16;
    case FileError::image: return says::cannot_read_image;
    case FileError::not_regular: return says::cannot_read_not_regular;
    case FileError::link_loop: return says::cannot_read_link_loop;
  }
  return says::cannot_read_not_readable;
}

}  // namespace

Bytes DiskFiles::read(std::string const& path) {
  if (!dash_is_standard_input_ || path != "-") return read_path(path, Pipes::refused);
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
  auto const opened = open_file(path, Pipes::refused);
  if (auto const* const error = std::get_if<FileError>(&opened)) return *error;
  return read_blocks(std::get<OpenFile>(opened).file, receive);
}

bool DiskFiles::is_file(std::string const& path) {
  return system::kind_of(path) == system::FileKind::regular;
}

std::vector<std::string> DiskFiles::names_in(std::string const& folder) {
  std::vector<std::string> names;
  auto entries = system::entries_of(folder);
  if (auto* const found = std::get_if<std::vector<system::FolderEntry>>(&entries)) {
    for (auto& entry : *found) names.push_back(std::move(entry.name));
  }
  return names;
}

bool DiskFiles::is_same(std::string const& one, std::string const& other) {
  auto const first = system::status_of(one);
  auto const second = system::status_of(other);
  auto const* const left = std::get_if<system::FileStatus>(&first);
  auto const* const right = std::get_if<system::FileStatus>(&second);
  return left != nullptr && right != nullptr && left->device == right->device && left->inode == right->inode;
}

Failure unreadable(std::string const& path, FileError error) {
  bool const large = error == FileError::too_large || error == FileError::line_too_long;
  return Failure({sentence(error), {{"file", path}}}, large ? too_large : cannot_read);
}

Failure unreadable(std::string const& path, system::Error const& error) {
  auto const known = error_of(error);
  if (known != FileError::not_readable) return unreadable(path, known);
  return Failure({says::cannot_read, {{"file", path}, {"reason", system::text_of(error)}}}, cannot_read);
}

std::string read_whole(std::string const& path, Dash dash) {
  bool const is_input = dash == Dash::is_standard_input && path == "-";
  return require(path, is_input ? DiskFiles(true).read(path) : read_path(path, Pipes::read));
}

std::string read_regular(std::string const& path) {
  return require(path, read_path(path, Pipes::refused));
}

}  // namespace axisc
