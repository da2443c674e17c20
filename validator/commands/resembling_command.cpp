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
    // Also without the blank before ON or OFF.
    for (std::string_view const switched : {"", " ON", " OFF"}) {
      std::string const better = std::string(proper_name(kind)).append(switched);
      std::string meant = better;
      std::erase(meant, ' ');
      bool const is_meant =
          switched.empty() ? schema::edit_distance(letters, meant, 1) <= 1 : letters == meant;
      if (!is_meant) continue;
      add_mistake(checked, kind, syntax_mistake, command.resembling, says::filter_syntax_misspelt,
                  {{"text", written}, {"command", better}})
          .better = better;
      return;
    }
  }
}

}  // namespace axisc::validator
