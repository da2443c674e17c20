#include "validator/files.hpp"

#include "grammar/axis_list.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace axisc::validator {
namespace {

bool is_image(std::string_view bytes) {
  return bytes.substr(0, 4) == "AXIM" && bytes.substr(0, 64).find('\0') != std::string_view::npos;
}

/// With its mark, or with a zero byte beside nearly every character.
bool is_utf16(std::string_view bytes) {
  std::string_view const mark = bytes.substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") return true;
  std::string_view const head = bytes.substr(0, judged_beginning);
  if (head.find('\0') == std::string_view::npos) return false;
  std::size_t zeros_at_even = 0;
  std::size_t zeros_at_odd = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\0') ++(i % 2 == 0 ? zeros_at_even : zeros_at_odd);
  }
  std::size_t const most = std::max(zeros_at_even, zeros_at_odd);
  std::size_t const least = std::min(zeros_at_even, zeros_at_odd);
  return head.size() >= 16 && most * 10 >= head.size() * 4 && least * 20 <= head.size();
}

/// How many bytes are control characters that no text has. Without branches, and in pieces of a fixed size, so that
/// compilers count many at once.
std::size_t count_controls(std::string_view text) {
  auto const is_control = [](char c) {
    auto const byte = static_cast<unsigned char>(c);
    auto const below_blank = static_cast<unsigned>(byte < 0x20);
    auto const white = static_cast<unsigned>(c == '\t') | static_cast<unsigned>(c == '\n') |
                       static_cast<unsigned>(c == '\r');
    return static_cast<unsigned char>((below_blank & ~white) | static_cast<unsigned>(byte == 0x7F));
  };
  constexpr std::size_t piece = 64;
  std::size_t count = 0;
  for (; text.size() >= piece; text.remove_prefix(piece)) {
    unsigned char inside = 0;
    for (std::size_t i = 0; i < piece; ++i) inside = static_cast<unsigned char>(inside + is_control(text[i]));
    count += inside;
  }
  for (char const c : text) count += is_control(c);
  return count;
}

bool is_binary(std::string_view bytes) {
  std::string_view const head = bytes.substr(0, judged_beginning);
  std::size_t const controls = count_controls(head);
  return controls >= 16 && controls * 20 >= head.size();
}

}  // namespace

std::optional<FileError> Files::read_pieces(std::string const& path, PieceReceiver const& receive) {
  std::variant<std::string, FileError> const bytes = read(path);
  if (auto const* const error = std::get_if<FileError>(&bytes)) return *error;
  receive(std::get<std::string>(bytes));
  return std::nullopt;
}

std::optional<FileError> check_beginning(std::string_view bytes) {
  if (is_image(bytes)) return FileError::image;
  if (is_utf16(bytes)) return FileError::utf16;
  if (is_binary(bytes)) return FileError::binary;
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

}  // namespace axisc::validator
