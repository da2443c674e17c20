#include "axisc/files/key_file.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/unique_name.hpp"
#include "codegen/source_digest.hpp"
#include "system/file.hpp"
#include "system/interruption.hpp"
#include "system/path.hpp"

#include <array>
#include <filesystem>
#include <span>

namespace axisc::says {

constexpr Sentence cannot_read_no_secret_key{
    "{file} is not a secret key; name the file that `axisc keygen` wrote, the one without .pub",
    "{file} ist kein geheimer Schlüssel; die Datei angeben, die `axisc keygen` schrieb, die ohne .pub"};
constexpr Sentence cannot_read_no_public_key{
    "{file} is not a public key; name the .pub file that `axisc keygen` wrote",
    "{file} ist kein öffentlicher Schlüssel; die .pub-Datei angeben, die `axisc keygen` schrieb"};
constexpr Sentence cannot_read_secret_shared{
    "{file} is a secret key that others may read; take their rights away: chmod 600 {file}",
    "{file} ist ein geheimer Schlüssel, den andere lesen dürfen; deren Rechte entziehen: chmod 600 {file}"};

constexpr Sentence cannot_write_key_exists{
    "{file} exists already; a key is never overwritten, choose another name",
    "{file} gibt es schon; ein Schlüssel wird nie überschrieben, einen anderen Namen wählen"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr unsigned others = 077;
constexpr std::size_t longest_key_file = 256;

[[noreturn]] void refuse_to_write(std::string const& path, system::Error const& error) {
  if (error.refusal == system::Refusal::exists) {
    throw Failure({says::cannot_write_key_exists, {{"file", path}}}, cannot_write);
  }
  throw Failure({says::cannot_write, {{"file", path}, {"reason", system::text_of(error)}}}, cannot_write);
}

/// A file that gets its name when it is complete. Without a name it is removed again, also when the program
/// is interrupted.
class NewFile {
 public:
  NewFile(std::string path, system::Privacy privacy)
      : path_(std::move(path)), temporary_(beside(path_)), interruption_(temporary_.c_str()) {
    auto made = system::File::create(temporary_, privacy);
    if (auto const* const error = std::get_if<system::Error>(&made)) refuse_to_write(path_, *error);
    file_ = std::get<system::File>(std::move(made));
  }
  NewFile(NewFile const&) = delete;
  NewFile& operator=(NewFile const&) = delete;
  ~NewFile() { system::remove(temporary_); }

  void write(std::string_view text) {
    auto error = file_.write(text);
    if (!error) error = file_.sync();
    if (!error) error = file_.close();
    if (error) refuse_to_write(path_, *error);
  }
  void give_name() {
    if (auto const error = system::give_new_name(temporary_, path_)) refuse_to_write(path_, *error);
  }
  void take_name_back() { system::remove(path_); }

 private:
  [[nodiscard]] static std::string beside(std::string const& path) {
    return system::name_of(system::path_of(path).parent_path() / system::path_of(".axisc-" + unique_name()));
  }

  std::string path_;
  std::string temporary_;
  system::RemovedWhenInterrupted interruption_;
  system::File file_;
};

/// The content of a key file, wiped afterwards.
class KeyText {
 public:
  explicit KeyText(system::File const& file) {
    while (size_ < bytes_.size()) {
      auto const result = file.read(std::span(bytes_).subspan(size_));
      auto const* const got = std::get_if<std::size_t>(&result);
      if (got == nullptr || *got == 0) break;
      size_ += *got;
    }
  }
  KeyText(KeyText const&) = delete;
  KeyText& operator=(KeyText const&) = delete;
  ~KeyText() { image::wipe(bytes_); }
  [[nodiscard]] std::string_view text() const { return {bytes_.data(), size_}; }

 private:
  std::array<char, longest_key_file> bytes_{};
  std::size_t size_ = 0;
};

system::File open_key(std::string const& path) {
  using configuration::FileError;
  auto opened = system::File::open(path, system::Access::read);
  auto const* const error = std::get_if<system::Error>(&opened);
  if (error == nullptr) return std::get<system::File>(std::move(opened));
  throw unreadable(path, error->refusal == system::Refusal::not_found       ? FileError::not_found
                         : error->refusal == system::Refusal::no_permission ? FileError::no_permission
                                                                            : FileError::not_readable);
}

}  // namespace

void write_keys(std::string const& path, image::SecretKey const& key) {
  NewFile open(path + ".pub", system::Privacy::readable);
  NewFile secret(path, system::Privacy::owner);
  open.write(image::public_key_text(key.public_key()));
  auto text = image::secret_key_text(key);
  try {
    secret.write(text);
  } catch (...) {
    image::wipe(text);
    throw;
  }
  image::wipe(text);
  // Both names or none.
  system::WithoutInterruption const uninterrupted;
  open.give_name();
  try {
    secret.give_name();
  } catch (...) {
    open.take_name_back();
    throw;
  }
}

image::SecretKey load_secret_key(std::string const& path) {
  system::File const file = open_key(path);
  KeyText const text(file);
  auto key = image::read_secret_key(text.text());
  if (!key) {
    throw Failure({says::cannot_read_no_secret_key, {{"file", path}}}, cannot_read);
  }
  auto const status = file.status();
  auto const* const facts = std::get_if<system::FileStatus>(&status);
  if (facts == nullptr || (facts->permissions & others) != 0) {
    throw Failure({says::cannot_read_secret_shared, {{"file", path}}}, cannot_read);
  }
  return std::move(*key);
}

image::PublicKey load_public_key(std::string const& path) {
  system::File const file = open_key(path);
  KeyText const text(file);
  auto const key = image::read_public_key(text.text());
  if (!key) {
    throw Failure({says::cannot_read_no_public_key, {{"file", path}}}, cannot_read);
  }
  return *key;
}

bool is_secret_key(std::string const& path) {
  auto const opened = system::File::open(path, system::Access::read_now);
  auto const* const file = std::get_if<system::File>(&opened);
  return file != nullptr && image::read_secret_key(KeyText(*file).text()).has_value();
}

std::string key_name(image::KeyId const& id) {
  return codegen::hexadecimal(id);
}

}  // namespace axisc
