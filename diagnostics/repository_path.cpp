#include "diagnostics/repository_path.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace axisc {
namespace {

namespace fs = std::filesystem;

bool may_stand_in_uri(char character) {
  bool const is_letter = (character >= 'A' && character <= 'Z') || (character >= 'a' && character <= 'z');
  bool const is_digit = character >= '0' && character <= '9';
  return is_letter || is_digit || std::string_view("-._~/").find(character) != std::string_view::npos;
}

}  // namespace

std::optional<std::string> path_in_repository(RepositoryPaths const& paths, std::string_view file) {
  if (file == "-" || file.empty() || paths.root.empty()) return std::nullopt;
  fs::path const whole = (fs::path(paths.folder) / fs::path(file)).lexically_normal();
  std::string const relative =
      whole.lexically_relative(fs::path(paths.root).lexically_normal()).generic_string();
  bool const outside = relative.empty() || relative == ".." || relative.substr(0, 3) == "../";
  return outside ? std::nullopt : std::optional(relative);
}

std::string shown_path(RepositoryPaths const& paths, std::string_view file) {
  return path_in_repository(paths, file).value_or(std::string(file));
}

std::string as_uri(std::string_view path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri;
  for (char const character : path) {
    if (may_stand_in_uri(character)) {
      uri += character;
      continue;
    }
    auto const byte = static_cast<unsigned char>(character);
    uri += '%';
    uri += digits[byte >> 4U];
    uri += digits[byte & 0xFU];
  }
  return uri;
}

}  // namespace axisc
