#include "axisc/workspace/uri.hpp"

#include "diagnostics/repository_path.hpp"

#include <algorithm>
#include <charconv>

namespace axisc {

namespace {

constexpr std::string_view scheme = "file://";
constexpr int hexadecimal = 16;

/// "c:/lists".
bool begins_at_drive(std::string_view path) {
  return begins_with_drive(path) && path.substr(2, 1) == "/";
}

/// "//server/share/x.lis" is a file of another computer.
bool has_shares(FileNames names) {
  return names == FileNames::windows;
}

}  // namespace

std::string path_of(std::string_view uri, FileNames names) {
  if (!uri.starts_with(scheme)) return std::string(uri);
  auto rest = uri.substr(scheme.size());
  auto const host = rest.substr(0, rest.find('/'));
  rest.remove_prefix(host.size());
  std::string path;
  if (has_shares(names) && !host.empty() && host != "localhost") path.append("//").append(host);
  while (!rest.empty()) {
    unsigned byte = 0;
    bool const is_escape =
        rest.size() >= 3 && rest[0] == '%' &&
        std::from_chars(rest.data() + 1, rest.data() + 3, byte, hexadecimal).ptr == rest.data() + 3;
    path += is_escape ? static_cast<char>(byte) : rest.front();
    rest.remove_prefix(is_escape ? 3 : 1);
  }
  if (path.starts_with('/') && begins_at_drive(std::string_view(path).substr(1))) path.erase(0, 1);
  return path;
}

std::string uri_of(std::string_view path, FileNames names) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri(scheme);
  if (begins_at_drive(path)) uri += '/';
  if (has_shares(names) && path.starts_with("//")) path.remove_prefix(2);
  for (char const character : path) {
    auto const byte = static_cast<unsigned char>(character);
    bool const is_plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                          (byte >= '0' && byte <= '9') ||
                          std::string_view("-._~/").find(character) != std::string_view::npos;
    if (is_plain) {
      uri += character;
    } else {
      uri += '%';
      uri += digits[byte >> 4U];
      uri += digits[byte & 0xFU];
    }
  }
  return uri;
}

}  // namespace axisc
