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

/// Lines are counted in blocks: a table of all lines would have a thousand entries to find one.
constexpr std::size_t block_size = 128;

/// The count fits in a byte and the size is fixed, so that compilers vectorize the loop.
std::uint32_t count_line_ends_of_block(char const* block) {
  unsigned char count = 0;
  for (std::size_t i = 0; i < block_size; ++i) {
    count = static_cast<unsigned char>(count + static_cast<unsigned char>(block[i] == '\n'));
  }
  return count;
}

std::uint32_t count_line_ends(std::string_view text) {
  std::uint32_t count = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1)) {
    ++count;
  }
  return count;
}

std::uint32_t mark_size(std::string_view bytes) {
  return bytes.starts_with(byte_order_mark) ? static_cast<std::uint32_t>(byte_order_mark.size()) : 0;
}

Encoding encoding_of(std::string_view bytes, bool is_ascii) {
  if (is_ascii) return Encoding::utf8;
  if (valid_utf8_prefix(bytes) != bytes.size()) return Encoding::windows_1252;
  return bytes.starts_with(byte_order_mark) ? Encoding::utf8_with_mark : Encoding::utf8;
}

}  // namespace

SourceText::SourceText(std::string name, std::string bytes)
    : name_(std::move(name)),
      file_(std::make_shared<std::string const>(std::move(bytes))),
      bytes_(*file_),
      text_begin_(mark_size(bytes_)),
      first_column_(text_begin_) {}

SourceText::SourceText(std::string name, Excerpt excerpt)
    : name_(std::move(name)),
      file_(std::make_shared<std::string const>(std::move(excerpt.bytes))),
      bytes_(*file_),
      numbers_(std::move(excerpt.numbers)),
      characters_({.are_ascii = ascii_prefix(bytes_) == bytes_.size(), .encoding = excerpt.encoding}) {
  numbers_.push_back(numbers_.empty() ? 1 : numbers_.back() + 1);
}

SourceText::SourceText(std::string name, Window const& window)
    : name_(std::move(name)), file_(window.file.file_), is_window_(true) {
  Line const& first = window.file.line_at(window.span.begin);
  std::uint32_t const begin = window.file.column_begin(first);
  bytes_ = std::string_view(*file_).substr(begin, window.span.end - begin);
  text_begin_ = window.span.begin - begin;
  lines_before_ = first.number - 1;
  bool const are_ascii = window.file.characters().are_ascii || ascii_prefix(bytes_) == bytes_.size();
  characters_ = {.are_ascii = are_ascii, .encoding = are_ascii ? Encoding::utf8 : window.encoding};
}

SourceText::SourceText(std::string name, Translation translation)
    : name_(std::move(name)), is_translation_(true), pieces_(std::move(translation.pieces)) {
  text_begin_ = static_cast<std::uint32_t>(translation.file.size()) + 1;
  first_column_ = mark_size(translation.file);
  for (TranslatedPiece& piece : pieces_) {
    piece.list.begin += text_begin_;
    piece.list.end += text_begin_;
  }
  std::string bytes = std::move(translation.file);
  bytes.append(1, '\n').append(translation.list);
  file_ = std::make_shared<std::string const>(std::move(bytes));
  bytes_ = *file_;
  bool const are_ascii = ascii_prefix(bytes_) == bytes_.size();
  characters_ = {.are_ascii = are_ascii, .encoding = are_ascii ? Encoding::utf8 : translation.encoding};
}

SourceText::Characters const& SourceText::characters() const {
  if (!characters_) {
    bool const are_ascii = ascii_prefix(bytes_) == bytes_.size();
    characters_ = {.are_ascii = are_ascii, .encoding = encoding_of(bytes_, are_ascii)};
  }
  return *characters_;
}

void SourceText::count_lines() const {
  if (!line_ends_before_.empty()) return;
  line_ends_before_.reserve(bytes_.size() / block_size + 2);
  std::uint32_t count = 0;
  std::string_view rest = bytes_;
  for (; rest.size() >= block_size; rest.remove_prefix(block_size)) {
    line_ends_before_.push_back(count);
    count += count_line_ends_of_block(rest.data());
  }
  line_ends_before_.push_back(count);
  line_ends_before_.push_back(count + count_line_ends(rest));
}

SourceText::Line const& SourceText::keep_line(std::uint32_t number, std::size_t begin) const {
  std::size_t const end = std::min(bytes_.find('\n', begin), bytes_.size());
  last_line_ = {
      .number = number, .begin = static_cast<std::uint32_t>(begin), .end = static_cast<std::uint32_t>(end)};
  return last_line_;
}

SourceText::Line const& SourceText::line_at(std::uint32_t offset) const {
  // Findings come in the order of their lines.
  constexpr std::uint32_t few_lines = 3;
  if (last_line_.number != 0 && last_line_.begin <= offset) {
    for (std::uint32_t further = 0; offset > last_line_.end && further < few_lines; ++further) {
      keep_line(last_line_.number + 1, last_line_.end + std::size_t{1});
    }
    if (offset <= last_line_.end) return last_line_;
  }
  count_lines();
  std::size_t const block = offset / block_size;
  std::string_view const before = bytes_.substr(0, offset);
  std::uint32_t const ends = line_ends_before_[block] + count_line_ends(before.substr(block * block_size));
  std::size_t const last_end = before.rfind('\n');
  return keep_line(ends + 1, last_end == std::string_view::npos ? 0 : last_end + 1);
}

SourceText::Line const& SourceText::line_numbered(std::uint32_t number) const {
  if (last_line_.number == number) return last_line_;
  count_lines();
  // The line begins after line end `number - 1`, in the last block that has fewer line ends before it.
  std::uint32_t ends = number - 1;
  auto const behind = std::lower_bound(line_ends_before_.begin(), line_ends_before_.end() - 1, ends);
  auto const block = behind == line_ends_before_.begin() ? behind : behind - 1;
  std::size_t begin = static_cast<std::size_t>(block - line_ends_before_.begin()) * block_size;
  for (ends -= *block; ends > 0; --ends) begin = bytes_.find('\n', begin) + 1;
  return keep_line(number, number == 1 ? 0 : begin);
}

Position SourceText::position(std::uint32_t offset) const {
  std::uint32_t const at = is_translation_
                               ? in_file(offset)
                               : std::clamp(offset, text_begin_, static_cast<std::uint32_t>(bytes_.size()));
  Line const& line = line_at(at);
  std::uint32_t const begin = column_begin(line);

  Position position{.line = numbers_.empty() ? lines_before_ + line.number : numbers_[line.number - 1],
                    .column = at - begin + 1};
  if (!characters().are_ascii && encoding() != Encoding::windows_1252) {
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
  if (is_excerpt()) {
    auto const number = std::lower_bound(numbers_.begin(), numbers_.end(), line);
    bool const is_held = number != numbers_.end() && *number == line;
    line = is_held ? static_cast<std::uint32_t>(number - numbers_.begin()) + 1 : 0;
  }
  line -= std::min(line, lines_before_);
  if (line == 0 || line > line_count()) return {.begin = size, .end = size};
  Line const& found = line_numbered(line);
  Span span{.begin = std::max(found.begin, is_translation_ ? first_column_ : text_begin_), .end = found.end};
  if (found.end < size && span.end > span.begin && bytes_[span.end - 1] == '\r') --span.end;
  return span;
}

Span SourceText::shown_line(std::uint32_t line) const {
  Span span = line_span(line);
  if (is_window_ && line == lines_before_ + 1) span.begin = 0;
  return span;
}

std::uint32_t SourceText::column_begin(Line const& line) const {
  return std::max(line.begin, first_column_);
}

std::uint32_t SourceText::in_file(std::uint32_t offset) const {
  auto const behind = std::upper_bound(
      pieces_.begin(), pieces_.end(), offset,
      [](std::uint32_t wanted, TranslatedPiece const& piece) { return wanted < piece.list.begin; });
  if (behind == pieces_.begin()) return std::clamp(offset, first_column_, text_begin_ - 1);
  TranslatedPiece const& piece = *std::prev(behind);
  if (offset >= piece.list.end) return piece.file.end;
  bool const is_verbatim = piece.list.size() == piece.file.size();
  return piece.file.begin + (is_verbatim ? offset - piece.list.begin : 0);
}

std::uint32_t SourceText::line_count() const {
  count_lines();
  return line_ends_before_.back() + 1;
}

bool SourceText::is_utf8(Span span) const {
  if (characters().are_ascii) return true;
  if (encoding() == Encoding::windows_1252 || is_excerpt()) return false;
  // The whole text is well-formed, so a part of it is, too, unless a character is cut.
  bool const begins_inside = span.begin < span.end && is_continuation_byte(bytes_[span.begin]);
  bool const ends_inside = span.end < bytes_.size() && is_continuation_byte(bytes_[span.end]);
  return !begins_inside && !ends_inside;
}

std::string_view SourceText::utf8(Span span, std::string& room) const {
  std::string_view const bytes = slice(span);
  if (is_utf8(span)) return bytes;
  room.clear();
  if (encoding() == Encoding::windows_1252) {
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
  if (encoding() != Encoding::windows_1252) return std::string(text);
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
