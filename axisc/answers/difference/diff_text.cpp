#include "axisc/answers/difference/diff_words.hpp"
#include "diagnostics/terminal.hpp"
#include "presentation/text_table.hpp"

#include <algorithm>

namespace axisc {

namespace {

/// Values of longer names are not aligned.
constexpr std::size_t longest_aligned_name = 40;
constexpr std::size_t line_width = 80;

std::string text_block(std::vector<DiffLine> const& lines) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(lines.size());
  for (auto const& line : lines) {
    rows.push_back({printable(line.what), printable(line.before), "→", printable(line.after)});
  }
  return presentation::text_table(rows, 2);
}

/// In one line where there is room.
std::string text_of(std::vector<std::string> const& places) {
  constexpr std::size_t indent = 6;
  std::string const begin(indent, ' ');
  auto text = begin + printable(places.front());
  if (places.size() == 1) return text + "\n";
  auto const last = " → " + printable(places.back());
  bool const has_room = presentation::display_width(text) + presentation::display_width(last) <= line_width;
  return text + (has_room ? "" : "\n" + begin.substr(1)) + last + "\n";
}

std::string text_of(DiffParameter const& parameter, std::size_t name_width) {
  auto const& line = parameter.line;
  std::string text = "  " + presentation::padded(line.what, name_width) + "  " + printable(line.before) +
                     " → " + printable(line.after) + "\n";
  for (auto const* const words : {&parameter.meaning, &parameter.restart}) {
    if (!words->empty()) text += "      " + *words + "\n";
  }
  for (auto const& places : parameter.places) text += text_of(places);
  return text;
}

std::string text_of(DiffSection const& section) {
  std::size_t name_width = 0;
  for (auto const& parameter : section.parameters) {
    auto const width = presentation::display_width(parameter.line.what);
    if (width <= longest_aligned_name) name_width = std::max(name_width, width);
  }
  std::string text = "\n" + printable(section.title) + "\n" + text_block(section.facts);
  for (auto const& parameter : section.parameters) text += text_of(parameter, name_width);
  if (section.effects.empty()) return text;
  bool const is_first = section.facts.empty() && section.parameters.empty();
  return text + (is_first ? "" : "\n") + text_block(section.effects);
}

}  // namespace

std::string diff_text(ShownDifference const& shown, Language language) {
  DiffWords const words(shown, language);
  std::string text = shown.difference.empty()
                         ? words.nothing(printable(shown.before), printable(shown.after)) + "\n"
                         : printable(shown.heading()) + "\n" + text_block(words.machine());
  for (auto const& section : words.channels()) text += text_of(section);
  for (auto const& section : words.axes()) text += text_of(section);
  auto const remarks = words.remarks();
  if (!remarks.empty()) text += "\n";
  for (auto const& remark : remarks) text += printable(remark) + "\n";
  return text;
}

}  // namespace axisc
