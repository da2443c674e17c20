#include "diagnostics/terminal.hpp"
#include "diagnostics/writers/writers.hpp"

#include <cstddef>
#include <string>

namespace axisc::says {

constexpr Sentence summary_files_one{"{count} file", "{count} Datei"};
constexpr Sentence summary_files_many{"{count} files", "{count} Dateien"};
constexpr Sentence summary_errors_one{"{count} error", "{count} Fehler"};
constexpr Sentence summary_errors_many{"{count} errors", "{count} Fehler"};
constexpr Sentence summary_warnings_one{"{count} warning", "{count} Warnung"};
constexpr Sentence summary_warnings_many{"{count} warnings", "{count} Warnungen"};
constexpr Sentence summary_notes_one{"{count} note", "{count} Hinweis"};
constexpr Sentence summary_notes_many{"{count} notes", "{count} Hinweise"};
constexpr Sentence summary_failures_one{"{count} input could not be checked",
                                        "{count} Eingabe war nicht prüfbar"};
constexpr Sentence summary_failures_many{"{count} inputs could not be checked",
                                         "{count} Eingaben waren nicht prüfbar"};
constexpr Sentence summary_nothing{"no findings", "keine Befunde"};

}  // namespace axisc::says

namespace axisc {
std::string write_text_summary(std::size_t files, FindingCounts const& counts, WriteOptions const& options,
                               std::size_t failures) {
  Painter const paint(options.color);
  Language const language = options.language;
  std::string found;
  auto const add = [&](std::size_t number, SentenceRef one, SentenceRef many, Style style) {
    if (number == 0) return;
    if (!found.empty()) found += ", ";
    found += paint(style, render(counted(number, one, many), language));
  };
  add(counts.errors, says::summary_errors_one, says::summary_errors_many, Style::error);
  add(counts.warnings, says::summary_warnings_one, says::summary_warnings_many, Style::warning);
  add(counts.notes, says::summary_notes_one, says::summary_notes_many, Style::note);
  add(failures, says::summary_failures_one, says::summary_failures_many, Style::error);
  if (found.empty()) found = render({says::summary_nothing}, language);
  return render(counted(files, says::summary_files_one, says::summary_files_many), language) + ": " + found +
         '\n';
}

}  // namespace axisc
