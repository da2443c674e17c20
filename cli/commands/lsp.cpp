#include "cli/checking/check_input.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/lsp_pages.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/formats/explain_formats.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "editor/framing.hpp"
#include "editor/server.hpp"
#include "system/file.hpp"

#include <array>
#include <optional>
#include <set>
#include <span>

namespace axisc::cli::says {

constexpr Sentence purpose{
    "Shows findings, fixes and the meaning of parameters in an editor: a language server on standard input "
    "and output, "
    "started by the editor.",
    "Zeigt Befunde, Korrekturen und die Bedeutung von Parametern im Editor: ein Language-Server auf "
    "Standardein- und "
    "-ausgabe, den der Editor startet."};
constexpr Sentence examples{
    R"(Example:
  axisc lsp                              see docs/editors.md for the settings of editors
  axisc lsp --cycle-time 2ms --lang de   what the editor's settings say

Exit status: 0 ended by the editor, 1 without a shutdown request, 2 input that is not of the protocol.)",
    R"(Beispiel:
  axisc lsp                              Einstellungen der Editoren: docs/editors.md
  axisc lsp --cycle-time 2ms --lang en   was in den Einstellungen des Editors steht

Rückgabewert: 0 vom Editor beendet, 1 ohne Anfrage nach dem Herunterfahren, 2 Eingabe, die nicht zum Protokoll gehört.)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus lsp(Invocation const& invocation) {
  CommandLine command_line("lsp", says::purpose, says::examples, invocation.language);
  CheckingOptions given;
  declare_control(command_line, given);
  if (command_line.answers(invocation)) return ExitStatus::success;
  auto const asked = check_options(given);
  DiskFiles disk;
  // Read again for every check: they may have changed. The options of a check refer to them.
  std::optional<SettingsFinder> settings;
  std::string failure;         // of the settings
  std::set<std::string> told;  // those that the user knows
  editor::OptionsOf const options = [&](std::string const& path) {
    settings.emplace();
    CheckJob job;
    job.options = asked;
    job.options.machine = false;
    job.settings = &*settings;
    try {
      return options_for(job, path);
    } catch (Failure const& mistake) {
      failure = mistake.sentence(invocation.language);
      return job.options;
    }
  };
  editor::Server server(
      {.disk = disk,
       .options = options,
       .explain =
           [&invocation](schema::Catalogue const& catalogue, schema::Parameter const& parameter) {
             return explain_parameter(catalogue, parameter, invocation.language);
           },
       .pages = editor_pages(options, invocation.language),
       .language = invocation.language});
  auto const opened = system::File::standard_input();
  auto const* const input = std::get_if<system::File>(&opened);
  if (input == nullptr) return ExitStatus::failure;
  auto const send = [&](std::vector<std::string> messages) {
    if (!failure.empty() && told.insert(failure).second) messages.push_back(editor::error_message(failure));
    failure.clear();
    for (auto const& message : messages) invocation.streams.out.write(editor::framed(message));
  };
  constexpr std::size_t block = 65536;
  std::array<char, block> buffer{};
  editor::FrameReader frames;
  while (!server.has_ended() && !frames.is_broken()) {
    auto const got = input->read(buffer);
    auto const* const size = std::get_if<std::size_t>(&got);
    if (size == nullptr || *size == 0) break;
    frames.add({buffer.data(), *size});
    while (auto const message = frames.next()) {
      send(server.receive(*message));
      if (server.has_ended()) break;
    }
    if (!server.has_ended()) send(server.publish());
    invocation.streams.out.flush();
  }
  if (frames.is_broken()) return ExitStatus::failure;
  return server.ended_properly() ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
