#include "axisc/files/output_file.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/files/path_identity.hpp"
#include "axisc/files/unique_name.hpp"
#include "system/path.hpp"

#include <utility>

namespace axisc::says {

constexpr Sentence no_folder{"cannot write {file}: its folder does not exist; create it first",
                             "{file} ist nicht schreibbar: den Ordner gibt es nicht; ihn zuerst anlegen"};
constexpr Sentence is_folder{"cannot write {file}: it is a folder; name a file in it",
                             "{file} ist nicht schreibbar: es ist ein Ordner; eine Datei darin angeben"};
constexpr Sentence no_permission{
    "cannot write {file}: permission denied; an existing file is unchanged",
    "{file} ist nicht schreibbar: keine Berechtigung; eine vorhandene Datei bleibt unverändert"};
constexpr Sentence read_only{"cannot write {file}: the file system is read-only",
                             "{file} ist nicht schreibbar: das Dateisystem ist schreibgeschützt"};
constexpr Sentence no_space{
    "cannot write {file}: no space is left; an existing file is unchanged",
    "{file} ist nicht schreibbar: kein Speicherplatz mehr; eine vorhandene Datei bleibt unverändert"};
constexpr Sentence closed_pipe{"cannot write {file}: the reader closed the pipe",
                               "{file} ist nicht schreibbar: die Gegenseite hat die Pipe geschlossen"};

constexpr Sentence changed{
    "cannot write {file}: it was changed while axisc worked on it; it stays as it is, run the command again",
    "{file} ist nicht schreibbar: während axisc daran arbeitete, wurde sie geändert; sie bleibt so, den "
    "Befehl wiederholen"};
constexpr Sentence no_new_folder{"the folder {folder} cannot be made: {reason}",
                                 "der Ordner {folder} lässt sich nicht anlegen: {reason}"};
constexpr Sentence link_loop{"cannot write {file}: its symbolic links lead in a circle",
                             "{file} ist nicht schreibbar: ihre symbolischen Links führen im Kreis"};

}  // namespace axisc::says

namespace axisc {

namespace {

SentenceRef sentence(system::Refusal refusal) {
  switch (refusal) {
    case system::Refusal::not_found: return says::no_folder;
    case system::Refusal::is_folder: return says::is_folder;
    case system::Refusal::no_permission: return says::no_permission;
    case system::Refusal::read_only: return says::read_only;
    case system::Refusal::no_space: return says::no_space;
    case system::Refusal::closed_pipe: return says::closed_pipe;
    case system::Refusal::link_loop: return says::link_loop;
    default: return says::cannot_write;
  }
}

std::string folder_of(std::string const& path) {
  auto const folder = system::name_of(system::path_of(path).parent_path());
  return folder.empty() ? "." : folder;
}

}  // namespace

OutputFile::TemporaryFile::~TemporaryFile() {
  if (!path.empty()) system::remove(path);
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_ == "-") {
    take(system::File::standard_output());
    return;
  }
  auto const status = system::status_of(path_);
  if (auto const* const error = std::get_if<system::Error>(&status)) {
    if (error->refusal != system::Refusal::not_found) fail(*error);
    target_ = behind_links(path_);
    open_beside(nullptr);
    return;
  }
  auto const& old = std::get<system::FileStatus>(status);
  if (old.kind == system::FileKind::folder) fail({.refusal = system::Refusal::is_folder, .number = 0});
  if (old.kind != system::FileKind::regular) {
    take(system::File::open(path_, system::Access::write));
    return;
  }
  target_ = behind_links(path_);
  open_beside(&old);
}

void OutputFile::take(system::Result<system::File> opened) {
  if (auto const* const error = std::get_if<system::Error>(&opened)) fail(*error);
  file_ = std::get<system::File>(std::move(opened));
}

void OutputFile::open_beside(system::FileStatus const* old) {
  // Renaming does not need write permission for the old file, but its write protection is respected.
  if (old != nullptr) require(system::refuses_writing(target_));
  std::string name = folder_of(target_) + "/.axisc-" + unique_name();
  {
    system::WithoutInterruption const made_and_remembered;
    // The new file is not readable by more users than the old one.
    take(system::File::create(name, old != nullptr ? system::Privacy::owner : system::Privacy::usual));
    temporary_.path = std::move(name);
    temporary_.interruption.emplace(temporary_.path.c_str());
  }
  if (old == nullptr) return;
  require(file_.take_over_owner(*old));
  file_.take_over_attributes(target_);
}

void OutputFile::fail(system::Error const& error) const {
  throw Failure({sentence(error.refusal), {{"file", path_}, {"reason", system::text_of(error)}}},
                cannot_write);
}

void OutputFile::require(std::optional<system::Error> const& error) const {
  if (error) fail(*error);
}

void OutputFile::write(std::string_view bytes) {
  require(file_.write(bytes));
}

void OutputFile::commit() {
  finish(nullptr);
}

void OutputFile::commit_over(std::string_view before) {
  finish(&before);
}

void OutputFile::finish(std::string_view const* before) {
  if (temporary_.path.empty()) {
    require(file_.close());
    return;
  }
  require(file_.sync());
  require(file_.close());
  if (before != nullptr && !is_content_of(target_, *before)) {
    throw Failure({says::changed, {{"file", path_}}}, cannot_write);
  }
  require(system::replace(temporary_.path, target_));
  temporary_.interruption.reset();
  temporary_.path.clear();
  // The name survives a power failure only when its folder is synced too; the content is safe either way.
  system::sync_folder(folder_of(target_));
}

bool is_content_of(std::string const& path, std::string_view bytes) {
  if (path == "-") return false;
  auto const opened = system::File::open(path, system::Access::read_now);
  auto const* const file = std::get_if<system::File>(&opened);
  if (file == nullptr) return false;
  auto const status = file->status();
  auto const* const facts = std::get_if<system::FileStatus>(&status);
  if (facts == nullptr || facts->kind != system::FileKind::regular || facts->size != bytes.size()) {
    return false;
  }
  std::string block(std::size_t{1} << 16U, '\0');
  while (!bytes.empty()) {
    auto const result = file->read(block);
    auto const* const length = std::get_if<std::size_t>(&result);
    if (length == nullptr || *length == 0) return false;
    if (bytes.substr(0, *length) != std::string_view(block).substr(0, *length)) return false;
    bytes.remove_prefix(*length);
  }
  return true;
}

void replace_content(std::string const& path, std::string_view before, std::string_view after) {
  // Several inputs may name one file in different ways.
  if (is_content_of(path, after)) return;
  OutputFile file(path);
  file.write(after);
  file.commit_over(before);
}

void make_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw Failure({says::no_new_folder, {{"folder", system::name_of(folder)}, {"reason", error.message()}}},
                cannot_write);
}

}  // namespace axisc
