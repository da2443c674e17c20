#include "validator/commands/resembling_command.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/edit_distance.hpp"
#include "validator/commands/command_mistake.hpp"

#include <string>

namespace axisc::validator::says {

constexpr Sentence filter_syntax_misspelt{"`{text}` is not a command; `{command}` is one",
                                          "`{text}` ist kein Befehl; `{command}` ist einer"};

}  // namespace axisc::validator::says

namespace axisc::validator {

using grammar::CommandKind;

void check_resembling(grammar::NcCommand const& command, std::string_view text, CheckedCommand& checked) {
  std::string const written(slice(text, command.resembling));
  std::string letters = ascii::upper_case(written);
  std::erase_if(letters, [](char byte) { return byte == '_' || ascii::is_blank(byte); });
  for (CommandKind const kind : {CommandKind::filter, CommandKind::vibration_guard}) {
    std::string const proper(proper_name(kind));
    std::string meant = proper;
    std::erase(meant, ' ');
    if (schema::edit_distance(letters, meant, 1) > 1) continue;
    add_mistake(checked, kind, syntax_mistake, command.resembling, says::filter_syntax_misspelt,
                {{"text", written}, {"command", proper}})
        .better = proper;
    return;
  }
}

}  // namespace axisc::validator
