#include "diagnostics/writers/fix_preview.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <boost/container/small_vector.hpp>

namespace axisc {
namespace {

// Nearly every fix is one edit in one line.
template <class Value>
using Few = boost::container::small_vector<Value, 4>;
using Lines = Few<std::string_view>;

Lines split(std::string_view text) {
  Lines lines;
  while (true) {
    std::size_t const end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (end < text.size() && line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    if (end == text.size()) return lines;
    text.remove_prefix(end + 1);
  }
}

/// In code points; both are well-formed.
std::size_t first_difference(std::string_view left, std::string_view right) {
  auto const* const equal = std::mismatch(left.begin(), left.end(), right.begin(), right.end()).first;
  auto const size = static_cast<std::size_t>(equal - left.begin());
  std::size_t const begun = size - count_continuation_bytes(left.substr(0, size));
  bool const is_inside = size < left.size() && is_continuation_byte(left[size]);
  return begun - (is_inside ? 1 : 0);
}

// Leaves only the differing lines in the middle, and returns the number of equal lines before them.
std::uint32_t drop_equal_lines(Lines& before, Lines& after) {
  while (!before.empty() && !after.empty() && before.back() == after.back()) {
    before.pop_back();
    after.pop_back();
  }
  auto const [end_before, end_after] =
      std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  auto const dropped = end_before - before.begin();
  before.erase(before.begin(), end_before);
  after.erase(after.begin(), end_after);
  return static_cast<std::uint32_t>(dropped);
}

std::vector<PreviewLine> preview_lines(Lines const& before, Lines const& after, std::uint32_t number) {
  std::vector<PreviewLine> lines;
  lines.reserve(before.size() + after.size());
  auto const add = [&](std::size_t i, bool added, std::string_view text, std::size_t first_change) {
    lines.push_back({.number = number + static_cast<std::uint32_t>(i),
                     .added = added,
                     .text = std::string(text),
                     .first_change = first_change});
  };
  for (std::size_t i = 0; i < before.size(); ++i) {
    add(i, false, before[i], i < after.size() ? first_difference(before[i], after[i]) : 0);
  }
  // Removed lines come first.
  for (std::size_t i = 0; i < after.size(); ++i) {
    add(i, true, after[i], i < before.size() ? lines[i].first_change : 0);
  }
  return lines;
}

// The edits [first, end) touch the lines from that of the first edit to `last_line`.
template <class Iterator>
PreviewBlock block_of(Iterator first, Iterator end, std::uint32_t last_line, SourceText const& source) {
  Place const place = (*first)->place;
  PreviewBlock block{.source = place.source, .begin = source.position(place.span.begin), .lines = {}};
  Span const region{.begin = source.shown_line(block.begin.line).begin,
                    .end = source.line_span(last_line).end};
  std::string edited, room;
  std::size_t added = 0;
  for (auto edit = first; edit != end; ++edit) added += (*edit)->text.size();
  edited.reserve(region.size() + added);
  std::uint32_t copied = region.begin;
  for (auto edit = first; edit != end; ++edit) {
    Span const span = (*edit)->place.span;
    edited += source.utf8({.begin = copied, .end = std::max(copied, span.begin)}, room);
    edited += (*edit)->text;
    copied = std::max(copied, span.end);
  }
  edited += source.utf8({.begin = copied, .end = std::max(copied, region.end)}, room);

  Lines before = split(source.utf8(region, room));
  Lines after = split(edited);
  std::uint32_t const number = block.begin.line + drop_equal_lines(before, after);
  block.lines = preview_lines(before, after, number);
  return block;
}

/// Sorted by place; the order of edits at the same place is kept.
Few<Edit const*> in_order(std::vector<Edit> const& edits) {
  Few<Edit const*> ordered;
  for (Edit const& edit : edits) ordered.push_back(&edit);
  auto const is_before = [](Edit const* left, Edit const* right) { return left->place < right->place; };
  // Stable sorting allocates even if nothing needs sorting, as for nearly all fixes.
  if (!std::is_sorted(ordered.begin(), ordered.end(), is_before)) {
    std::stable_sort(ordered.begin(), ordered.end(), is_before);
  }
  return ordered;
}

}  // namespace

std::vector<PreviewBlock> preview(Fix const& fix, SourceSet const& sources) {
  Few<Edit const*> const edits = in_order(fix.edits);
  std::vector<PreviewBlock> blocks;
  for (auto first = edits.begin(); first != edits.end();) {
    SourceId const id = (*first)->place.source;
    SourceText const& source = sources[id];
    std::uint32_t last_line = source.position((*first)->place.span.end).line;
    auto end = first + 1;
    while (end != edits.end() && (*end)->place.source == id &&
           source.position((*end)->place.span.begin).line <= last_line) {
      last_line = std::max(last_line, source.position((*end)->place.span.end).line);
      ++end;
    }
    blocks.push_back(block_of(first, end, last_line, source));
    first = end;
  }
  return blocks;
}

}  // namespace axisc
