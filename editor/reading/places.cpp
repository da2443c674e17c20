#include "editor/reading/places.hpp"

#include "diagnostics/location.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

std::vector<std::uint32_t> lone_returns_of(SourceText const& source) {
  std::vector<std::uint32_t> lines;
  if (source.is_excerpt() || source.is_translation()) return lines;
  std::string_view const text = *source.file();
  std::uint32_t line = 1;
  std::size_t counted = 0;
  for (auto at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
    if (text.substr(at, 2) == "\r\n") continue;
    line += static_cast<std::uint32_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                  text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

Json position_json(TextPosition position) {
  return {{"line", position.line}, {"character", position.character}};
}

Json range_json(TextPosition begin, TextPosition end) {
  return {{"start", position_json(begin)}, {"end", position_json(end)}};
}

Json range_between(std::string_view text, std::size_t begin, std::size_t end, PositionEncoding encoding) {
  TextLines const lines(text, encoding);
  return range_json(lines.position(begin), lines.position(end));
}

std::string Places::uri(Place const& place) const {
  return buffers_.uri(sources_[place.source].name());
}

Json Places::position(SourceId source, Position at) const {
  auto const& text = sources_[source];
  auto const line = text.utf8(text.shown_line(at.line));
  auto const [known, is_new] = lone_returns_.try_emplace(source);
  if (is_new) known->second = lone_returns_of(text);
  auto const& returns = known->second;
  TextPosition position{.line = at.line - 1, .character = units(line, at.column - 1, encoding_)};
  if (!returns.empty()) {
    auto const before = std::lower_bound(returns.begin(), returns.end(), at.line) - returns.begin();
    auto const inside =
        TextLines(line, encoding_).position(offset_of_unit(line, position.character, encoding_));
    position = {.line = position.line + static_cast<std::size_t>(before) + inside.line,
                .character = inside.character};
  }
  return position_json(position);
}

Json Places::range(Place const& place) const {
  auto const location = locate(place, sources_);
  return {{"start", position(place.source, location.begin)}, {"end", position(place.source, location.end)}};
}

Json Places::location(Place const& place) const {
  return {{"uri", uri(place)}, {"range", range(place)}};
}

Json edits_between(std::string_view before, std::string_view after, PositionEncoding encoding) {
  auto edits = Json::array();
  if (before == after) return edits;
  auto const shorter = std::min(before.size(), after.size());
  std::size_t begin = 0;
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  std::size_t end = 0;
  while (end < shorter - begin && before[before.size() - 1 - end] == after[after.size() - 1 - end]) ++end;
  // Edits do not split characters or CR LF.
  auto const is_inside = [](std::string_view text, std::size_t at) {
    return at > 0 && at < text.size() &&
           (is_continuation_byte(text[at]) || (text[at - 1] == '\r' && text[at] == '\n'));
  };
  while (is_inside(before, begin) || is_inside(after, begin)) --begin;
  while (is_inside(before, before.size() - end) || is_inside(after, after.size() - end)) --end;
  edits.push_back({{"range", range_between(before, begin, before.size() - end, encoding)},
                   {"newText", after.substr(begin, after.size() - end - begin)}});
  return edits;
}

}  // namespace axisc::editor
