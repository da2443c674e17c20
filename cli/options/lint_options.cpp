#include "cli/options/lint_options.hpp"

#include "axisc/environment/failure.hpp"
#include "cli/options/named_files.hpp"
#include "cli/options/sentences.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence statistics_format{"--statistics needs --format text or json",
                                     "--statistics geht nur mit --format text oder json"};
constexpr Sentence option_write_baseline{
    "record the findings in this file; they count as accepted, in this run too",
    "die Befunde in dieser Datei festhalten; sie gelten als hingenommen, auch in diesem Lauf"};
constexpr Sentence option_changed_since{
    "only what differs from a revision of git: machines of which a file does, and lists of no machine; INPUT "
    "is the working folder if it is left out",
    "nur, was sich von einer Revision von git unterscheidet: Maschinen, von denen eine Datei es tut, und "
    "Listen ohne Maschine; ohne INPUT im Arbeitsordner"};
constexpr Sentence changed_standard_input{
    "--changed-since cannot be used with standard input, which is in no revision",
    "--changed-since geht nicht mit der Standardeingabe, die in keiner Revision steht"};
constexpr Sentence changed_baseline{
    "--changed-since cannot be used with --write-baseline, which would record the findings of some inputs "
    "only; write the baseline without it",
    "--changed-since geht nicht zusammen mit --write-baseline, die nur die Befunde einiger Eingaben "
    "festhielte; die Baseline ohne es schreiben"};
constexpr Sentence option_select{
    "look for these codes alone, by code, name or beginning (AX3*); may be repeated",
    "nur nach diesen Codes sehen, als Code, Name oder Anfang (AX3*); mehrmals möglich"};
constexpr Sentence option_fail_on{
    "what leads to exit status 1: error, warning (as --werror) or never; what cannot be read leads to 2",
    "was zum Rückgabewert 1 führt: error, warning (wie --werror) oder never; nicht Lesbares führt zu 2"};
constexpr Sentence option_statistics{"print how often each code was found (text and json)",
                                     "ausgeben, wie oft jeder Code gefunden wurde (text und json)"};
constexpr Sentence option_fix{
    "write the fixes that do not change what the machine does; =all: the others as well",
    "die Korrekturen schreiben, die nicht ändern, was die Maschine tut; =all: auch die anderen"};
constexpr Sentence option_diff{
    "print what --fix (or --fix=all) would write, as a patch; findings go to standard error",
    "als Patch zeigen, was --fix (oder --fix=all) schreiben würde; Befunde gehen auf die "
    "Standardfehlerausgabe"};

constexpr Sentence option_print_config{
    "show which settings apply to each input and where they come from",
    "zeigen, welche Einstellungen für jede Eingabe gelten und woher sie kommen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare(CommandLine& command_line, LintOptions& options) {
  command_line.arguments("INPUT...", options.named, says::argument_inputs);
  declare_checking(command_line, options.checking);
  command_line.values("--select", "CODE[,CODE]", options.checking.selected, says::option_select);
  command_line.choice("--fail-on",
                      {{"error", FailOn::error}, {"warning", FailOn::warning}, {"never", FailOn::never}},
                      options.fail_on, says::option_fail_on);
  command_line.value("--stdin-filename", "NAME", options.stdin_filename, says::option_stdin_filename);
  declare_hook(command_line, options.hook);
  declare_alone(command_line, options.alone);
  command_line.flag_with_value("--fix", "[=all]", options.fix, says::option_fix);
  command_line.flag("--diff", options.diff, says::option_diff);
  command_line.value("--changed-since", "REF", options.changed_since, says::option_changed_since);
  command_line.value("--baseline", "FILE", options.baseline, says::option_baseline);
  command_line.value("--write-baseline", "FILE", options.write_baseline, says::option_write_baseline);
  command_line.flag("--statistics", options.statistics, says::option_statistics);
  command_line.flag("--print-config", options.print_config, says::option_print_config);
}

void require_sense(CommandLine const& command_line, LintOptions const& options) {
  command_line.require(!options.named.empty(), "INPUT");
  if (options.changed_since) {
    bool const names_standard_input =
        std::find(options.named.begin(), options.named.end(), "-") != options.named.end();
    if (names_standard_input || options.stdin_filename) {
      throw Failure({says::changed_standard_input});
    }
    if (options.write_baseline) throw Failure({says::changed_baseline});
  }
  bool const countable =
      options.checking.format == FindingFormat::text || options.checking.format == FindingFormat::json;
  if (options.statistics && !countable) throw Failure({says::statistics_format});
}

FixChoice fix_choice(LintOptions const& options) {
  if (!options.fix) return options.diff ? FixChoice::safe : FixChoice::none;
  if (options.fix->empty()) return FixChoice::safe;
  if (*options.fix == "all") return FixChoice::all;
  throw Failure({says::bad_choice, {{"option", "--fix"}, {"value", *options.fix}, {"choices", "all"}}});
}

bool is_judged(LintOptions const& given, validator::CheckOptions const& options, Code code) {
  auto const* const rule = validator::find_rule(code);
  if (rule == nullptr) return true;
  bool const shown = rule->severity != Severity::note || (options.pedantic && !given.checking.quiet);
  return shown && std::find(options.disabled.begin(), options.disabled.end(), code) == options.disabled.end();
}

}  // namespace axisc::cli
