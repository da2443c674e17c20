#include "image/fmu/names.hpp"

#include <algorithm>

namespace axisc::image {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_identifier(std::string_view name) {
  return !name.empty() && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace

std::string quoted_name(std::string_view name) {
  if (is_identifier(name)) return std::string(name);
  std::string text = "'";
  for (char const c : name) {
    if (c == '\'' || c == '"' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < ' ' || c == '\x7F' ? ' ' : c;
  }
  return text + "'";
}

bool is_ascii(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x80; });
}

std::string identifier(std::string_view name) {
  std::string text;
  if (!name.empty() && is_digit(name.front())) text = "_";
  for (char const c : name) text += is_letter(c) || is_digit(c) ? c : '_';
  return text.empty() ? "model" : text;
}

}  // namespace axisc::image
