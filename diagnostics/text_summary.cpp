#include "diagnostics/terminal.hpp"
#include "diagnostics/writers.hpp"

#include <cstddef>
#include <string>

namespace axisc {
namespace {

std::string counted(std::size_t number, Text one, Text many, Language language) {
  return render(
      {.text = number == 1 ? one : many, .arguments = {{.name = "count", .value = std::to_string(number)}}},
      language);
}

}  // namespace

std::string write_text_summary(std::size_t files, FindingCounts const& counts, WriteOptions const& options) {
  Painter const paint(options.color);
  Language const language = options.language;
  std::string found;
  auto const add = [&](std::size_t number, Text one, Text many, Style style) {
    if (number == 0) return;
    if (!found.empty()) found += ", ";
    found += paint(style, counted(number, one, many, language));
  };
  add(counts.errors, Text::summary_errors_one, Text::summary_errors_many, Style::error);
  add(counts.warnings, Text::summary_warnings_one, Text::summary_warnings_many, Style::warning);
  add(counts.notes, Text::summary_notes_one, Text::summary_notes_many, Style::note);
  if (found.empty()) found = render({.text = Text::summary_nothing, .arguments = {}}, language);
  return counted(files, Text::summary_files_one, Text::summary_files_many, language) + ": " + found + '\n';
}

}  // namespace axisc
