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
  std::size_t zeros_at_even = 0;
  std::size_t zeros_at_odd = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\0') ++(i % 2 == 0 ? zeros_at_even : zeros_at_odd);
  }
  std::size_t const most = std::max(zeros_at_even, zeros_at_odd);
  std::size_t const least = std::min(zeros_at_even, zeros_at_odd);
  return head.size() >= 16 && most * 10 >= head.size() * 4 && least * 20 <= head.size();
}

bool is_binary(std::string_view bytes) {
  std::string_view const head = bytes.substr(0, judged_beginning);
  auto const controls = static_cast<std::size_t>(std::count_if(head.begin(), head.end(), [](char c) {
    auto const byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
  }));
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
  if (grammar::longest_line_in(bytes) > grammar::longest_line) return FileError::line_too_long;
  return std::monostate{};
}

}  // namespace axisc::validator
