#include "cli/files/program_lines.hpp"

#include "cli/codes.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace axisc::cli {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16U;
constexpr std::size_t longest_line = std::size_t{1} << 20U;
/// Places in a program have 32 bits.
constexpr std::uint64_t longest_program = std::numeric_limits<std::uint32_t>::max();

[[noreturn]] void fail(std::string const& path, int error) {
  if (error == ENOENT) throw unreadable(path, configuration::FileError::not_found);
  if (error == EISDIR) throw unreadable(path, configuration::FileError::is_folder);
  if (error == EACCES) throw unreadable(path, configuration::FileError::no_permission);
  throw Failure({.text = Text::ax9001, .arguments = {{"file", path}, {"reason", system_error_text(error)}}},
                cannot_read);
}

}  // namespace

ProgramLines::ProgramLines(std::string path) : path_(std::move(path)) {
  bool const is_input = path_ == "-";
  if (!is_input) {
    file_ = FileDescriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file_.is_open()) fail(path_, errno);
  }
  struct stat facts {};
  int const descriptor = is_input ? 0 : file_.get();
  if (::fstat(descriptor, &facts) != 0) fail(path_, errno);
  if (S_ISDIR(facts.st_mode)) fail(path_, EISDIR);
  if (!is_input && S_ISREG(facts.st_mode)) {
    size_ = static_cast<std::uint64_t>(facts.st_size);
  } else {
    in_memory_ = true;
    std::string buffer(piece, '\0');
    while (auto const got = ::read(descriptor, buffer.data(), buffer.size())) {
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail(path_, errno);
      content_.append(buffer, 0, static_cast<std::size_t>(got));
    }
    size_ = content_.size();
  }
  if (size_ >= longest_program) throw unreadable(path_, configuration::FileError::too_large);
}

std::size_t ProgramLines::fill(char* buffer, std::size_t size) {
  if (in_memory_) {
    std::size_t const some = std::min(size, content_.size() - static_cast<std::size_t>(read_));
    std::memcpy(buffer, content_.data() + read_, some);
    read_ += some;
    return some;
  }
  while (true) {
    auto const got = ::pread(file_.get(), buffer, size, static_cast<off_t>(read_));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, errno);
    read_ += static_cast<std::uint64_t>(got);
    if (read_ >= longest_program) throw unreadable(path_, configuration::FileError::too_large);
    return static_cast<std::size_t>(got);
  }
}

void ProgramLines::read(std::function<bool(std::string_view, std::uint32_t)> const& line) {
  read_ = 0;
  std::string buffer;
  std::uint32_t offset = 0;  // of the buffer's first byte
  std::size_t searched = 0;
  for (bool more = true; more;) {
    std::size_t const held = buffer.size();
    buffer.resize(held + piece);
    std::size_t const got = fill(buffer.data() + held, piece);
    buffer.resize(held + got);
    more = got > 0;
    if (offset == 0 && held == 0 && buffer.rfind("\xEF\xBB\xBF", 0) == 0) {
      buffer.erase(0, 3);
      offset = 3;
    }
    std::size_t begin = 0;
    while (true) {
      std::size_t const end = buffer.find('\n', std::max(begin, searched));
      bool const whole = end != std::string::npos;
      if (!whole && (more || begin == buffer.size())) break;
      std::string_view text(buffer.data() + begin, (whole ? end : buffer.size()) - begin);
      if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
      if (!line(text, offset + static_cast<std::uint32_t>(begin))) return;
      begin = whole ? end + 1 : buffer.size();
    }
    buffer.erase(0, begin);
    offset += static_cast<std::uint32_t>(begin);
    searched = buffer.size();
    if (buffer.size() > longest_line) throw unreadable(path_, configuration::FileError::line_too_long);
  }
}

}  // namespace axisc::cli
