#include "diagnostics/fix_batch.hpp"

#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

bool can_be_written(SourceText const& source, std::string_view text) {
  if (source.encoding() != Encoding::windows_1252) return true;
  while (!text.empty()) {
    DecodedCharacter const character = decode_utf8(text);
    if (!encode_windows_1252(character.value)) return false;
    text.remove_prefix(character.size);
  }
  return true;
}

bool has_windows_line_ends(std::string_view bytes) {
  std::size_t const end = bytes.find('\n');
  return end != std::string_view::npos && end > 0 && bytes[end - 1] == '\r';
}

/// An edit says "\n" for a line end of whatever kind.
std::string with_line_ends(std::string const& text, bool windows) {
  if (!windows) return text;
  std::string result;
  for (char const character : text) {
    if (character == '\n') result += '\r';
    result += character;
  }
  return result;
}

}  // namespace

bool FixBatch::fits(Edit const& edit) const {
  if (!can_be_written(sources_[edit.place.source], edit.text)) return false;
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
  std::uint32_t copied = 0;
  auto const finish = [&] {
    if (!edited.empty()) edited.back().bytes += sources_[edited.back().source].bytes().substr(copied);
  };
  for (auto const& [place, text] : edits_) {
    if (edited.empty() || edited.back().source != place.source) {
      finish();
      edited.push_back({.source = place.source, .bytes = {}});
      copied = 0;
    }
    SourceText const& source = sources_[place.source];
    edited.back().bytes += source.slice({.begin = copied, .end = place.span.begin});
    edited.back().bytes += with_line_ends(source.encode(text), has_windows_line_ends(source.bytes()));
    copied = place.span.end;
  }
  finish();
  return edited;
}

}  // namespace axisc
