#include "diagnostics/source_text.hpp"

#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

Encoding encoding_of(std::string_view bytes, bool is_ascii) {
  if (is_ascii) return Encoding::utf8;
  if (valid_utf8_prefix(bytes) != bytes.size()) return Encoding::windows_1252;
  return bytes.starts_with(byte_order_mark) ? Encoding::utf8_with_mark : Encoding::utf8;
}

}  // namespace

SourceText::SourceText(std::string name, std::string bytes)
    : name_(std::move(name)),
      bytes_(std::move(bytes)),
      is_ascii_(ascii_prefix(bytes_) == bytes_.size()),
      encoding_(encoding_of(bytes_, is_ascii_)),
      text_begin_(std::string_view(bytes_).starts_with(byte_order_mark) ? std::uint32_t{3} : 0) {}

SourceText::SourceText(std::string name, Excerpt excerpt)
    : name_(std::move(name)),
      bytes_(std::move(excerpt.bytes)),
      is_ascii_(ascii_prefix(bytes_) == bytes_.size()),
      encoding_(excerpt.encoding),
      text_begin_(0),
      numbers_(std::move(excerpt.numbers)) {
  numbers_.push_back(numbers_.empty() ? 1 : numbers_.back() + 1);
}

std::vector<std::uint32_t> const& SourceText::line_starts() const {
  if (line_starts_.empty()) {
    constexpr std::size_t usual_line = 32;
    line_starts_.reserve(bytes_.size() / usual_line + 1);
    line_starts_.push_back(0);
    std::string_view const text = bytes_;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1)) {
      line_starts_.push_back(static_cast<std::uint32_t>(end + 1));
    }
  }
  return line_starts_;
}

std::uint32_t SourceText::line_at(std::uint32_t offset) const {
  auto const& starts = line_starts();
  bool const is_last = last_line_ == starts.size();
  if (offset < starts[last_line_ - 1] || (!is_last && offset >= starts[last_line_])) {
    auto const behind = std::upper_bound(starts.begin(), starts.end(), offset);
    last_line_ = static_cast<std::uint32_t>(behind - starts.begin());
  }
  return last_line_;
}

Position SourceText::position(std::uint32_t offset) const {
  std::uint32_t const at = std::clamp(offset, text_begin_, static_cast<std::uint32_t>(bytes_.size()));
  auto const& starts = line_starts();
  std::uint32_t const line = line_at(at);
  std::uint32_t const begin = std::max(starts[line - 1], text_begin_);

  Position position{.line = numbers_.empty() ? line : numbers_[line - 1], .column = at - begin + 1};
  if (encoding_ != Encoding::windows_1252 && !is_ascii_) {
    // Continuation bytes up to and including `at` belong to characters that began before.
    std::string_view const before = slice({.begin = begin, .end = at});
    std::size_t inside = count_continuation_bytes(before);
    if (at < bytes_.size() && is_continuation_byte(bytes_[at])) ++inside;
    position.column -= static_cast<std::uint32_t>(inside);
  }
  return position;
}

Span SourceText::line_span(std::uint32_t line) const {
  auto const size = static_cast<std::uint32_t>(bytes_.size());
  auto const& starts = line_starts();
  if (is_excerpt()) {
    auto const number = std::lower_bound(numbers_.begin(), numbers_.end(), line);
    bool const is_held = number != numbers_.end() && *number == line;
    line = is_held ? static_cast<std::uint32_t>(number - numbers_.begin()) + 1 : 0;
  }
  if (line == 0 || line > starts.size()) return {.begin = size, .end = size};
  bool const is_last = line == starts.size();
  Span span{.begin = std::max(starts[line - 1], text_begin_), .end = is_last ? size : starts[line] - 1};
  if (!is_last && span.end > span.begin && bytes_[span.end - 1] == '\r') --span.end;
  return span;
}

std::uint32_t SourceText::line_count() const {
  return static_cast<std::uint32_t>(line_starts().size());
}

bool SourceText::is_utf8(Span span) const {
  if (is_ascii_) return true;
  if (encoding_ == Encoding::windows_1252 || is_excerpt()) return false;
  // The whole text is well-formed, so that a part of it is unless a character is cut.
  bool const begins_inside = span.begin < span.end && is_continuation_byte(bytes_[span.begin]);
  bool const ends_inside = span.end < bytes_.size() && is_continuation_byte(bytes_[span.end]);
  return !begins_inside && !ends_inside;
}

std::string_view SourceText::utf8(Span span, std::string& room) const {
  std::string_view const bytes = slice(span);
  if (is_utf8(span)) return bytes;
  room.clear();
  if (encoding_ == Encoding::windows_1252) {
    for (char const byte : bytes) append_utf8(room, decode_windows_1252(byte));
  } else {
    append_repaired(room, bytes);
  }
  return room;
}

std::string SourceText::utf8(Span span) const {
  std::string room;
  std::string_view const text = utf8(span, room);
  if (room.empty()) room = text;
  return room;
}

std::string SourceText::encode(std::string_view text) const {
  if (encoding_ != Encoding::windows_1252) return std::string(text);
  std::string bytes;
  bytes.reserve(text.size());
  while (!text.empty()) {
    DecodedCharacter const character = decode_utf8(text);
    bytes += encode_windows_1252(character.value).value_or('?');
    text.remove_prefix(character.size);
  }
  return bytes;
}

}  // namespace axisc
