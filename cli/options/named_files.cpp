#include "cli/options/named_files.hpp"

#include "diagnostics/sentences.hpp"

namespace axisc::cli::says {

constexpr Sentence option_hook{
    "for hooks that name all files of a commit: other JSON, XML and project files, and files that settings "
    "exclude, are passed over as in a folder; @x.lis is a file",
    "für Hooks, die alle Dateien eines Commits angeben: andere JSON-, XML- und Projektdateien und per "
    "Einstellung ausgeschlossene werden wie in einem Ordner übergangen; @x.lis ist eine Datei"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare_hook(CommandLine& command_line, bool& hook) {
  command_line.flag("--hook", hook, says::option_hook);
}

std::string note_lines(std::vector<Message> const& notes, Language language) {
  std::string lines;
  for (auto const& note : notes) {
    lines.append("axisc: ").append(axisc::says::word_note.in(language)).append(": ");
    lines.append(render(note, language)).append("\n");
  }
  return lines;
}

}  // namespace axisc::cli
