#include "axisc/files/program_lines.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace axisc {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16U;
constexpr std::size_t longest_line = std::size_t{1} << 20U;
/// Offsets in a program have 32 bits.
constexpr std::uint64_t longest_program = std::numeric_limits<std::uint32_t>::max();

/// The value, or a failure.
template <typename Value>
Value require(std::string const& path, system::Result<Value> result) {
  if (auto const* const error = std::get_if<system::Error>(&result)) throw unreadable(path, *error);
  return std::get<Value>(std::move(result));
}

}  // namespace

ProgramLines::ProgramLines(std::string path) : path_(std::move(path)) {
  bool const is_input = path_ == "-";
  file_ = require(
      path_, is_input ? system::File::standard_input() : system::File::open(path_, system::Access::read_now));
  auto const facts = require(path_, file_.status());
  if (facts.kind == system::FileKind::folder) throw unreadable(path_, configuration::FileError::is_folder);
  if (!is_input) {
    if (facts.kind != system::FileKind::regular) {
      throw unreadable(path_, configuration::FileError::not_regular);
    }
    size_ = facts.size;
  } else {
    in_memory_ = true;
    std::string buffer(piece, '\0');
    while (auto const got = require(path_, file_.read(buffer))) content_.append(buffer, 0, got);
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
  auto const got = require(path_, file_.read_at(read_, {buffer, size}));
  read_ += got;
  if (read_ >= longest_program) throw unreadable(path_, configuration::FileError::too_large);
  return got;
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
    if (offset == 0 && held == 0 && buffer.starts_with(byte_order_mark)) {
      buffer.erase(0, byte_order_mark.size());
      offset = byte_order_mark.size();
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

}  // namespace axisc
