#include "cli/options/lint_options.hpp"

#include "cli/failure.hpp"
#include "cli/sentences.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence statistics_format{"--statistics needs --format text or json",
                                     "--statistics geht nur mit --format text oder json"};
constexpr Sentence option_write_baseline{
    "record the findings in this file; they count as accepted, in this run too",
    "die Befunde in dieser Datei festhalten; sie gelten als hingenommen, auch in diesem Lauf"};
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

constexpr Sentence shard_fix{
    "--shard cannot be used with --fix or --diff: machines of several shards may share lists",
    "--shard geht nicht zusammen mit --fix oder --diff: Maschinen mehrerer Teile können sich Listen teilen"};
constexpr Sentence shard_baseline{
    "--shard cannot be used with {option}, which counts the findings of all inputs; give the baseline to "
    "`axisc "
    "merge`",
    "--shard geht nicht zusammen mit {option}, die die Befunde aller Eingaben zählt; die Baseline `axisc "
    "merge` geben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare(CommandLine& command_line, LintWords& words) {
  command_line.arguments("INPUT...", words.named, says::argument_inputs);
  declare_checking(command_line, words.checking);
  command_line.flag_with_word("--fix", "[=all]", words.fix, says::option_fix);
  command_line.flag("--diff", words.diff, says::option_diff);
  command_line.value("--baseline", "FILE", words.baseline, says::option_baseline);
  command_line.value("--write-baseline", "FILE", words.write_baseline, says::option_write_baseline);
  command_line.flag("--statistics", words.statistics, says::option_statistics);
  command_line.flag("--print-config", words.print_config, says::option_print_config);
  declare_fleet(command_line, words.fleet);
}

void require_sense(CommandLine const& command_line, LintWords const& words) {
  command_line.require(!words.named.empty(), "INPUT");
  bool const countable =
      words.checking.format == FindingFormat::text || words.checking.format == FindingFormat::json;
  if (words.statistics && !countable) throw Failure({.sentence = says::statistics_format, .arguments = {}});
  if (!words.fleet.shard) return;
  if (words.fix || words.diff) throw Failure({.sentence = says::shard_fix, .arguments = {}});
  for (auto const& [given, option] : {std::pair(words.baseline.has_value(), "--baseline"),
                                      {words.write_baseline.has_value(), "--write-baseline"}}) {
    if (given) throw Failure({.sentence = says::shard_baseline, .arguments = {{"option", option}}});
  }
}

FixChoice fix_choice(LintWords const& words) {
  if (!words.fix) return words.diff ? FixChoice::safe : FixChoice::none;
  if (words.fix->empty()) return FixChoice::safe;
  if (*words.fix == "all") return FixChoice::all;
  throw Failure({.sentence = says::bad_choice,
                 .arguments = {{"option", "--fix"}, {"value", *words.fix}, {"choices", "all"}}});
}

bool is_judged(LintWords const& words, validator::CheckOptions const& options, Code code) {
  auto const* const rule = validator::find_rule(code);
  if (rule == nullptr) return true;
  bool const shown = rule->severity != Severity::note || (options.pedantic && !words.checking.quiet);
  return shown && std::find(options.disabled.begin(), options.disabled.end(), code) == options.disabled.end();
}

}  // namespace axisc::cli
