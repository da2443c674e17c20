#include "axisc/environment/failure.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "embedded.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_schema{
    "a kind of file: machine files, settings (axisc.json), plant files, schema files, which describe "
    "parameters; a line of --format jsonl; or the command that writes --format json",
    "eine Art von Dateien: Maschinendateien, Einstellungen (axisc.json), Streckendateien, Schemadateien, die "
    "Parameter beschreiben; eine Zeile von --format jsonl; oder der Befehl, der --format json schreibt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus schema(Invocation const& invocation) {
  std::vector<std::string> kinds;
  for (auto const& [name, text] : schemas::embedded_texts) kinds.emplace_back(name);
  std::optional<std::string> word;
  CommandLine command_line("schema", invocation.language);
  command_line.argument("KIND", word, says::argument_schema, kinds);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(word.has_value(), "KIND");
  std::string names;
  for (auto const& [name, text] : schemas::embedded_texts) {
    if (name == *word) {
      invocation.streams.out.write(text());
      return ExitStatus::success;
    }
    names.append(names.empty() ? "" : ", ").append(name);
  }
  throw Failure(
      {says::bad_choice, {{"option", "axisc schema"}, {"value", *word}, {"choices", std::move(names)}}});
}

}  // namespace axisc::cli
