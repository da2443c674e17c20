#include "cli/options/help_text.hpp"

#include "presentation/text_table.hpp"
#include "system/process.hpp"

#include <algorithm>

namespace axisc::cli {

namespace {

constexpr std::size_t widest = 100;
constexpr std::size_t narrowest = 40;
constexpr std::size_t meaning_column = 30;
/// A shorter line of a text ends a paragraph; a longer one was broken there for the eye.
constexpr std::size_t shortest_full_line = 80;
/// Below this width meanings have lines of their own.
constexpr std::size_t two_columns = 70;

/// Appends words to `text`, whose last line has `column` columns; further lines begin with `indent` blanks.
void append_words(std::string& text, std::string_view words, std::size_t column, std::size_t indent,
                  std::size_t width) {
  bool first = true;
  while (!words.empty()) {
    auto const word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    if (!first && column + 1 + presentation::display_width(word) > width) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      text += ' ';
      ++column;
    }
    text += word;
    column += presentation::display_width(word);
    first = false;
  }
}

void append_example(std::string& text, std::string_view line, std::size_t width) {
  auto const begin = line.find_first_not_of(' ');
  auto const gap = line.find("   ", begin);
  if (presentation::display_width(line) <= width || gap == std::string_view::npos) {
    text += line;
    return;
  }
  auto const indent = begin + 4;
  text.append(line.substr(0, gap)).append("\n").append(indent, ' ');
  append_words(text, line.substr(line.find_first_not_of(' ', gap)), indent, indent, width);
}

}  // namespace

std::size_t help_width() {
  return std::clamp(system::terminal_width().value_or(widest), narrowest, widest);
}

std::string help_row(std::string_view name, std::string_view meaning, std::size_t width) {
  constexpr std::size_t narrow_column = 6;
  auto const indent = width < two_columns ? narrow_column : meaning_column;
  std::string text = "  " + std::string(name);
  auto const column = 2 + presentation::display_width(name);
  bool const fits = column + 2 <= indent;
  text.append(fits ? "" : "\n").append(fits ? indent - column : indent, ' ');
  append_words(text, meaning, indent, indent, width);
  return text + '\n';
}

std::string help_paragraphs(std::string_view text, std::size_t width) {
  std::string result;
  std::string paragraph;
  auto const end_paragraph = [&] {
    append_words(result, paragraph, 0, 0, width);
    if (!paragraph.empty()) result += '\n';
    paragraph.clear();
  };
  while (!text.empty()) {
    auto const line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.empty() && line.front() != ' ') {
      paragraph.append(paragraph.empty() ? "" : " ").append(line);
      if (presentation::display_width(line) < shortest_full_line) end_paragraph();
      continue;
    }
    end_paragraph();
    append_example(result, line, width);
    result += '\n';
  }
  end_paragraph();
  return result;
}

}  // namespace axisc::cli
