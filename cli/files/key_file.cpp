#include "cli/files/key_file.hpp"

#include "cli/codes.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/failure.hpp"
#include "cli/files/file_descriptor.hpp"
#include "cli/options/filter_symbols.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axisc::cli {

namespace {

constexpr mode_t owner_only = 0600;
constexpr mode_t everybody_reads = 0644;
constexpr mode_t others = 077;
constexpr std::size_t longest_key_file = 256;

[[noreturn]] void refuse_to_write(std::string const& path, int error) {
  if (error == EEXIST) {
    throw Failure({.text = Text::ax9002_key_exists, .arguments = {{"file", path}}}, cannot_write);
  }
  throw Failure({.text = Text::ax9002, .arguments = {{"file", path}, {"reason", system_error_text(error)}}},
                cannot_write);
}

/// Removed again unless it is kept.
class NewFile {
 public:
  NewFile(std::string path, mode_t mode)
      : path_(std::move(path)), file_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode)) {
    if (!file_.is_open()) refuse_to_write(path_, errno);
  }
  NewFile(NewFile const&) = delete;
  NewFile& operator=(NewFile const&) = delete;
  ~NewFile() {
    if (!kept_) ::unlink(path_.c_str());
  }
  void write(std::string_view text) {
    int error = write_all(file_.get(), text);
    if (error == 0 && ::fsync(file_.get()) != 0) error = errno;
    if (error == 0) error = file_.close();
    if (error != 0) refuse_to_write(path_, error);
  }
  void keep() { kept_ = true; }

 private:
  std::string path_;
  FileDescriptor file_;
  bool kept_ = false;
};

/// What is read of a key file, wiped afterwards.
class KeyText {
 public:
  explicit KeyText(int descriptor) {
    while (size_ < bytes_.size()) {
      auto const got = ::read(descriptor, bytes_.data() + size_, bytes_.size() - size_);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      size_ += static_cast<std::size_t>(got);
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

FileDescriptor open_key(std::string const& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.is_open()) return file;
  auto const error = errno == ENOENT || errno == ENOTDIR ? configuration::FileError::not_found
                     : errno == EACCES || errno == EPERM ? configuration::FileError::no_permission
                                                         : configuration::FileError::not_readable;
  throw unreadable(path, error);
}

}  // namespace

void write_keys(std::string const& path, image::SecretKey const& key) {
  NewFile open(path + ".pub", everybody_reads);
  NewFile secret(path, owner_only);
  open.write(image::public_key_text(key.public_key()));
  auto text = image::secret_key_text(key);
  try {
    secret.write(text);
  } catch (...) {
    image::wipe(text);
    throw;
  }
  image::wipe(text);
  open.keep();
  secret.keep();
}

image::SecretKey load_secret_key(std::string const& path) {
  FileDescriptor const file = open_key(path);
  KeyText const text(file.get());
  auto key = image::read_secret_key(text.text());
  if (!key) throw Failure({.text = Text::ax9001_no_secret_key, .arguments = {{"file", path}}}, cannot_read);
  struct stat facts {};
  if (::fstat(file.get(), &facts) != 0 || (facts.st_mode & others) != 0) {
    throw Failure({.text = Text::ax9001_secret_shared, .arguments = {{"file", path}}}, cannot_read);
  }
  return std::move(*key);
}

image::PublicKey load_public_key(std::string const& path) {
  FileDescriptor const file = open_key(path);
  KeyText const text(file.get());
  auto const key = image::read_public_key(text.text());
  if (!key) throw Failure({.text = Text::ax9001_no_public_key, .arguments = {{"file", path}}}, cannot_read);
  return *key;
}

std::string key_name(image::KeyId const& id) {
  return hexadecimal(id);
}

}  // namespace axisc::cli
