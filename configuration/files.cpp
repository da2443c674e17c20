#include "configuration/files.hpp"

#include "grammar/axis_list.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace axisc::configuration {
namespace {

bool is_image(std::string_view bytes) {
  return bytes.substr(0, 4) == "AXIM" && bytes.substr(0, 64).find('\0') != std::string_view::npos;
}

bool has_utf16_mark(std::string_view bytes) {
  std::string_view const mark = bytes.substr(0, 2);
  return mark == "\xFF\xFE" || mark == "\xFE\xFF";
}

/// Nearly every character has a zero byte next to it.
bool is_utf16(std::string_view head) {
  std::size_t zeros_at_even = 0;
  std::size_t zeros_at_odd = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\0') ++(i % 2 == 0 ? zeros_at_even : zeros_at_odd);
  }
  std::size_t const most = std::max(zeros_at_even, zeros_at_odd);
  std::size_t const least = std::min(zeros_at_even, zeros_at_odd);
  return head.size() >= 16 && most * 10 >= head.size() * 4 && least * 20 <= head.size();
}

/// The number of control characters that do not occur in text. Without branches, and in pieces of a fixed
/// size, so that compilers vectorize the loop.
std::size_t count_controls(std::string_view text) {
  auto const is_control = [](char c) {
    auto const byte = static_cast<unsigned char>(c);
    bool const is_white = byte == '\t' || byte == '\n' || byte == '\r';
    return static_cast<unsigned char>((byte < 0x20 && !is_white) || byte == 0x7F);
  };
  constexpr std::size_t piece = 128;
  // Prefetches: text that is not in the caches comes from farther away than the processor looks ahead by
  // itself.
  constexpr std::size_t line_of_cache = 64;
  constexpr std::size_t ahead = 2048;
  std::size_t count = 0;
  for (; text.size() >= piece; text.remove_prefix(piece)) {
    if (text.size() > ahead + line_of_cache) {
      __builtin_prefetch(text.data() + ahead);
      __builtin_prefetch(text.data() + ahead + line_of_cache);
    }
    unsigned char inside = 0;
    for (std::size_t i = 0; i < piece; ++i) inside = static_cast<unsigned char>(inside + is_control(text[i]));
    count += inside;
  }
  for (char const c : text) count += is_control(c);
  return count;
}

}  // namespace

bool Files::is_file(std::string const& path) {
  return std::holds_alternative<std::string>(read(path));
}

std::vector<std::string> Files::names_in(std::string const& /*folder*/) {
  return {};
}

bool Files::is_same(std::string const& one, std::string const& other) {
  return one == other;
}

std::optional<FileError> Files::read_pieces(std::string const& path, PieceReceiver const& receive) {
  std::variant<std::string, FileError> const bytes = read(path);
  if (auto const* const error = std::get_if<FileError>(&bytes)) return *error;
  receive(std::get<std::string>(bytes));
  return std::nullopt;
}

std::optional<FileError> check_beginning(std::string_view bytes) {
  if (is_image(bytes)) return FileError::image;
  if (has_utf16_mark(bytes)) return FileError::utf16;
  std::string_view const head = bytes.substr(0, judged_beginning);
  std::size_t const controls = count_controls(head);
  // As in nearly every text.
  if (controls == 0) return std::nullopt;
  if (is_utf16(head)) return FileError::utf16;
  if (controls >= 16 && controls * 20 >= head.size()) return FileError::binary;
  return std::nullopt;
}

std::variant<std::monostate, FileError> check_text(std::string_view bytes) {
  if (bytes.size() > largest_file) return FileError::too_large;
  if (auto const error = check_beginning(bytes)) return *error;
  // No line of a short text is too long.
  if (bytes.size() > grammar::longest_line && grammar::longest_line_in(bytes) > grammar::longest_line) {
    return FileError::line_too_long;
  }
  return std::monostate{};
}

}  // namespace axisc::configuration
