#include "editor/framing.hpp"

#include "diagnostics/ascii.hpp"

#include <charconv>

namespace axisc::editor {

namespace {

constexpr std::size_t longest_header = 4096;

std::optional<std::size_t> content_length(std::string_view header) {
  constexpr std::string_view name = "content-length:";
  while (!header.empty()) {
    auto const end = header.find("\r\n");
    auto line = header.substr(0, end);
    header.remove_prefix(end == std::string_view::npos ? header.size() : end + 2);
    if (!ascii::equal_ignoring_case(line.substr(0, name.size()), name)) continue;
    line.remove_prefix(name.size());
    while (line.starts_with(' ')) line.remove_prefix(1);
    std::size_t length = 0;
    auto const [stop, error] = std::from_chars(line.data(), line.data() + line.size(), length);
    bool const is_number = error == std::errc() && stop == line.data() + line.size();
    if (!is_number || length > longest_message) return std::nullopt;
    return length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> FrameReader::next() {
  if (is_broken_) return std::nullopt;
  auto const end = pending_.find("\r\n\r\n");
  if (end == std::string::npos) {
    is_broken_ = pending_.size() > longest_header;
    return std::nullopt;
  }
  auto const length = content_length(std::string_view(pending_).substr(0, end));
  if (!length) {
    is_broken_ = true;
    return std::nullopt;
  }
  auto const begin = end + 4;
  if (pending_.size() - begin < *length) return std::nullopt;
  auto message = pending_.substr(begin, *length);
  pending_.erase(0, begin + *length);
  return message;
}

std::string framed(std::string_view message) {
  return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

}  // namespace axisc::editor
