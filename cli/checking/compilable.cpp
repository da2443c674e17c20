#include "cli/checking/compilable.hpp"

#include "cli/failure.hpp"
#include "cli/options/machine_outline.hpp"
#include "cli/sentences.hpp"

namespace axisc::cli::says {

constexpr Sentence cycle_time_missing{
    "the NC cycle time for {file} is not known and decides every coefficient; give it, as in --cycle-time "
    "1ms",
    "die NC-Zykluszeit zu {file} ist nicht bekannt und bestimmt alle Koeffizienten; sie angeben, etwa "
    "--cycle-time 1ms"};
constexpr Sentence machine_cycle_time_missing{
    "{file} states no NC cycle time, which decides every coefficient; add \"cycle_time_us\" or give "
    "--cycle-time 1ms",
    "{file} nennt keine NC-Zykluszeit, die alle Koeffizienten bestimmt; \"cycle_time_us\" ergänzen oder "
    "--cycle-time 1ms angeben"};
constexpr Sentence machine_file_silenced{
    "{file} has mistakes that are silenced (AX4020), and no machine can be made of it; correct them",
    "{file} hat Fehler, die unterdrückt sind (AX4020), und daraus entsteht keine Maschine; sie beheben"};
constexpr Sentence other_list{"{file} is not an axis list, so it configures no filter",
                              "{file} ist keine Achsliste und konfiguriert keinen Filter"};
constexpr Sentence not_compiled{
    "{place}: this version cannot compile {feature}; switch it off to compile the rest",
    "{place}: diese Version kann {feature} nicht übersetzen; abschalten, um den Rest zu übersetzen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void require_cycle_time(std::string const& input, validator::CheckResult const& result) {
  bool const is_machine = has_extension(input, ".json");
  if (result.is_other_list) throw Failure({.sentence = says::other_list, .arguments = {{"file", input}}});
  // Mistakes in the machine file are reported first: the cycle time may be one of them.
  if (result.cycle_time_known || (is_machine && !result.machine)) return;
  throw Failure({.sentence = is_machine ? says::machine_cycle_time_missing : says::cycle_time_missing,
                 .arguments = {{"file", input}}});
}

void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language) {
  if (result.is_other_list) throw Failure({.sentence = says::other_list, .arguments = {{"file", input}}});
  if (!result.machine) {
    bool const is_program = has_extension(input, ".nc");
    throw Failure({.sentence = is_program ? says::nc_program : says::machine_file_silenced,
                   .arguments = {{"file", input}}});
  }
  if (result.not_compiled.empty()) return;
  auto const& first = result.not_compiled.front();
  auto const& source = sources[first.place.source];
  throw Failure({.sentence = says::not_compiled,
                 .arguments = {{"place", source.name() + ":" +
                                             std::to_string(source.position(first.place.span.begin).line)},
                               {"feature", render(first.feature, language)}}});
}

}  // namespace axisc::cli
