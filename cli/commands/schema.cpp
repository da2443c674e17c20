#include "axisc/environment/failure.hpp"
#include "axisc/settings/json_schema.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence argument_file_kind{
    "machine files, settings (axisc.json), plant files, schema files, which describe parameters, or findings",
    "Maschinendateien, Einstellungen (axisc.json), Streckendateien, Schemadateien, die Parameter "
    "beschreiben, oder Befunde"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::string_view kind_argument = "machine|settings|plant|schema|finding";

}  // namespace

ExitStatus schema(Invocation const& invocation) {
  std::optional<std::string> word;
  CommandLine command_line("schema", invocation.language);
  command_line.argument(kind_argument, word, says::argument_file_kind);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(word.has_value(), kind_argument);
  auto const kinds = json_file_kinds();
  auto const kind =
      std::find_if(kinds.begin(), kinds.end(), [&](JsonFileKind const& each) { return each.name == *word; });
  if (kind == kinds.end()) {
    throw Failure({.sentence = says::bad_choice,
                   .arguments = {{"option", "axisc schema"},
                                 {"value", *word},
                                 {"choices", "machine, settings, plant, schema, finding"}}});
  }
  invocation.streams.out.write(json_schema(kind->shape));
  return ExitStatus::success;
}

}  // namespace axisc::cli
