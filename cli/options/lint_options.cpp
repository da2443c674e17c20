#include "cli/options/lint_options.hpp"

#include "cli/failure.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli {

void declare(CommandLine& command_line, LintWords& words) {
  command_line.arguments("INPUT...", words.named, Text::cli_arg_inputs);
  declare_checking(command_line, words.checking);
  command_line.flag_with_word("--fix", "[=all]", words.fix, Text::cli_opt_fix);
  command_line.flag("--diff", words.diff, Text::cli_opt_lint_diff);
  command_line.value("--baseline", "FILE", words.baseline, Text::cli_opt_baseline);
  command_line.value("--write-baseline", "FILE", words.write_baseline, Text::cli_opt_write_baseline);
  command_line.flag("--statistics", words.statistics, Text::cli_opt_statistics);
  command_line.flag("--print-config", words.print_config, Text::cli_opt_print_config);
  declare_fleet(command_line, words.fleet);
}

void require_sense(CommandLine const& command_line, LintWords const& words) {
  command_line.require(!words.named.empty(), "INPUT");
  bool const countable =
      words.checking.format == FindingFormat::text || words.checking.format == FindingFormat::json;
  if (words.statistics && !countable) throw Failure({.text = Text::cli_statistics_format, .arguments = {}});
  if (!words.fleet.shard) return;
  if (words.fix || words.diff) throw Failure({.text = Text::cli_shard_fix, .arguments = {}});
  for (auto const& [given, option] : {std::pair(words.baseline.has_value(), "--baseline"),
                                      {words.write_baseline.has_value(), "--write-baseline"}}) {
    if (given) throw Failure({.text = Text::cli_shard_baseline, .arguments = {{"option", option}}});
  }
}

FixChoice fix_choice(LintWords const& words) {
  if (!words.fix) return words.diff ? FixChoice::safe : FixChoice::none;
  if (words.fix->empty()) return FixChoice::safe;
  if (*words.fix == "all") return FixChoice::all;
  throw Failure({.text = Text::cli_bad_choice,
                 .arguments = {{"option", "--fix"}, {"value", *words.fix}, {"choices", "all"}}});
}

bool is_judged(LintWords const& words, validator::CheckOptions const& options, Code code) {
  auto const* const rule = validator::find_rule(code);
  if (rule == nullptr) return true;
  bool const shown = rule->severity != Severity::note || (options.pedantic && !words.checking.quiet);
  return shown && std::find(options.disabled.begin(), options.disabled.end(), code) == options.disabled.end();
}

}  // namespace axisc::cli
