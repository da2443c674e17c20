#include "cli/checking/compilable.hpp"

#include "cli/failure.hpp"
#include "cli/options/machine_outline.hpp"

namespace axisc::cli {

void require_cycle_time(std::string const& input, validator::CheckResult const& result) {
  bool const is_machine = has_extension(input, ".json");
  // A machine file with mistakes is judged first: the cycle time may be one of them.
  if (result.cycle_time_known || (is_machine && !result.machine)) return;
  throw Failure({.text = is_machine ? Text::cli_machine_cycle_time_missing : Text::cli_cycle_time_missing,
                 .arguments = {{"file", input}}});
}

void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language) {
  if (!result.machine) {
    bool const is_program = has_extension(input, ".nc");
    throw Failure({.text = is_program ? Text::cli_nc_program : Text::cli_machine_file_silenced,
                   .arguments = {{"file", input}}});
  }
  if (result.not_compiled.empty()) return;
  auto const& first = result.not_compiled.front();
  auto const& source = sources[first.place.source];
  throw Failure({.text = Text::cli_not_compiled,
                 .arguments = {{"place", source.name() + ":" +
                                             std::to_string(source.position(first.place.span.begin).line)},
                               {"feature", render(first.feature, language)}}});
}

}  // namespace axisc::cli
