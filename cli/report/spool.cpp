#include "cli/report/spool.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/files/interruption.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace axisc::cli {

namespace {

constexpr std::size_t most_in_memory = std::size_t{8} << 20U;
constexpr std::size_t block_size = std::size_t{1} << 20U;

struct Header {
  std::uint64_t mark = 0;
  std::uint64_t size = 0;
};

[[noreturn]] void fail(std::string const& place, int error) {
  throw Failure({.text = Text::ax9002, .arguments = {{"file", place}, {"reason", system_error_text(error)}}},
                cannot_write);
}

std::string temporary_folder() {
  std::error_code error;
  auto const folder = std::filesystem::temp_directory_path(error);
  return error ? "/tmp" : folder.string();
}

/// Removed at once: it lives as long as it is open, however the program ends.
FileDescriptor open_nameless() {
  auto const folder = temporary_folder();
  auto name = folder + "/axisc-XXXXXX";
  WithoutInterruption const made_and_removed;
  FileDescriptor file(::mkstemp(name.data()));
  if (!file.is_open()) fail(folder, errno);
  ::unlink(name.c_str());
  return file;
}

/// Hands over the whole entries at the beginning of `bytes`; returns their length.
std::size_t replay_entries(std::string_view bytes,
                           std::function<void(std::uint64_t, std::string_view)> const& take) {
  std::size_t at = 0;
  while (bytes.size() - at >= sizeof(Header)) {
    Header header;
    std::memcpy(&header, bytes.data() + at, sizeof(header));
    if (bytes.size() - at - sizeof(header) < header.size) break;
    take(header.mark, bytes.substr(at + sizeof(header), header.size));
    at += sizeof(header) + header.size;
  }
  return at;
}

}  // namespace

void Spool::add(std::uint64_t mark, std::string_view text) {
  // At once: memory that is not written to costs nothing, while growth by doubling copies everything again and again.
  if (buffer_.capacity() < most_in_memory) buffer_.reserve(most_in_memory + block_size);
  Header const header{.mark = mark, .size = text.size()};
  buffer_.append(reinterpret_cast<char const*>(&header), sizeof(header)).append(text);
  if (buffer_.size() >= most_in_memory) spill();
}

void Spool::spill() {
  if (!file_.is_open()) file_ = open_nameless();
  if (int const error = write_all(file_.get(), buffer_); error != 0) fail(temporary_folder(), error);
  buffer_.clear();
}

void Spool::replay(std::function<void(std::uint64_t, std::string_view)> const& take) {
  if (file_.is_open()) {
    spill();
    if (::lseek(file_.get(), 0, SEEK_SET) < 0) fail(temporary_folder(), errno);
    std::string block(block_size, '\0');
    while (true) {
      auto const got = ::read(file_.get(), block.data(), block.size());
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail(temporary_folder(), errno);
      if (got == 0) break;
      buffer_.append(block, 0, static_cast<std::size_t>(got));
      buffer_.erase(0, replay_entries(buffer_, take));
    }
  }
  static_cast<void>(replay_entries(buffer_, take));
}

}  // namespace axisc::cli
