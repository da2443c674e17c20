#include "diagnostics/fix_batch.hpp"

#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

bool can_be_written(SourceText const& source, std::string_view text) {
  if (source.encoding() != Encoding::windows_1252) return true;
  while (!text.empty()) {
    DecodedCharacter const character = decode_utf8(text);
    if (!encode_windows_1252(character.value)) return false;
    text.remove_prefix(character.size);
  }
  return true;
}

namespace {

/// The end of the CDATA section of a window.
constexpr std::string_view section_end = "]]>";

/// True where the edit, together with the text around it, would end the section.
bool ends_section(SourceText const& source, Edit const& edit) {
  if (!source.is_window()) return false;
  Span const span = edit.place.span;
  std::string_view const before = source.bytes().substr(0, span.begin);
  std::string_view const after = source.bytes().substr(span.end);
  std::size_t const reach = section_end.size() - 1;
  std::string text(before.substr(before.size() - std::min(before.size(), reach)));
  text.append(edit.text).append(after.substr(0, reach));
  return text.find(section_end) != std::string::npos;
}

bool has_windows_line_ends(std::string_view bytes) {
  std::size_t const end = bytes.find('\n');
  return end != std::string_view::npos && end > 0 && bytes[end - 1] == '\r';
}

/// An edit has "\n" for a line end of any kind.
std::string with_line_ends(std::string const& text, bool windows) {
  if (!windows) return text;
  std::string result;
  for (char const character : text) {
    if (character == '\n') result += '\r';
    result += character;
  }
  return result;
}

std::size_t width(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char byte) { return !is_continuation_byte(byte); }));
}

/// The blanks of a column gap that begins at `begin`: at least two, followed by more text on the line, and
/// untouched by other edits.
std::uint32_t gap_behind(std::string_view bytes, std::uint32_t begin, std::size_t limit) {
  std::size_t const end = std::min(bytes.find_first_not_of(' ', begin), bytes.size());
  bool const is_gap = end >= begin + 2 && end < bytes.size() && end <= limit &&
                      std::string_view("\t\r\n").find(bytes[end]) == std::string_view::npos;
  return is_gap ? static_cast<std::uint32_t>(end - begin) : 0;
}

/// The number of blanks that replace the `gap` old ones, so that the following text keeps its column.
std::size_t adjusted(std::uint32_t gap, std::size_t old_width, std::size_t new_width) {
  return old_width + gap > new_width ? old_width + gap - new_width : 1;
}

}  // namespace

bool FixBatch::fits(Edit const& edit) const {
  SourceText const& source = sources_[edit.place.source];
  if (source.is_excerpt() || ends_section(source, edit) || !can_be_written(source, edit.text)) return false;
  auto const next = edits_.lower_bound(edit.place);
  bool const meets_next = next != edits_.end() && next->first.source == edit.place.source &&
                          next->first.span.begin <= edit.place.span.end;
  if (meets_next || next == edits_.begin()) return !meets_next;
  Place const& before = std::prev(next)->first;
  return before.source != edit.place.source || before.span.end < edit.place.span.begin;
}

bool FixBatch::add(Fix const& fix) {
  std::vector<Place> added;
  for (Edit const& edit : fix.edits) {
    if (!fits(edit)) {
      for (Place const& place : added) edits_.erase(place);
      return false;
    }
    edits_.emplace(edit.place, edit.text);
    added.push_back(edit.place);
  }
  return true;
}

std::vector<EditedSource> FixBatch::apply() const {
  std::vector<EditedSource> edited;
  std::size_t copied = 0;
  auto const file_of = [&](SourceId id) -> std::string const& { return *sources_[id].file(); };
  auto const finish = [&] {
    if (!edited.empty()) {
      edited.back().bytes += std::string_view(file_of(edited.back().source)).substr(copied);
    }
  };
  for (auto edit = edits_.begin(); edit != edits_.end(); ++edit) {
    auto const& [place, text] = *edit;
    SourceText const& source = sources_[place.source];
    if (edited.empty() || &file_of(edited.back().source) != source.file().get()) {
      finish();
      edited.push_back({.source = place.source, .bytes = {}});
      copied = 0;
    }
    std::string& bytes = edited.back().bytes;
    std::size_t const offset = source.file_offset();
    bytes.append(*source.file(), copied, offset + place.span.begin - copied);
    bytes += with_line_ends(source.encode(text), has_windows_line_ends(source.bytes()));
    copied = offset + place.span.end;
    auto const next = std::next(edit);
    bool const is_followed = next != edits_.end() && next->first.source == place.source;
    std::uint32_t const gap = gap_behind(source.bytes(), place.span.end,
                                         is_followed ? next->first.span.begin : source.bytes().size());
    if (gap == 0 || place.span.empty() || text.find('\n') != std::string_view::npos) continue;
    bytes.append(adjusted(gap, width(source.utf8(place.span)), width(text)), ' ');
    copied += gap;
  }
  finish();
  return edited;
}

}  // namespace axisc
