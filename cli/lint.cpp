#include "cli/baseline.hpp"
#include "cli/check_inputs.hpp"
#include "cli/checking.hpp"
#include "cli/commands.hpp"
#include "cli/finding_report.hpp"
#include "cli/fixing.hpp"
#include "cli/inputs.hpp"
#include "cli/output_file.hpp"
#include "cli/report_context.hpp"
#include "diagnostics/unified_diff.hpp"
#include "validator/rule.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace axisc::cli {

namespace {

struct LintWords {
  CheckingWords checking;
  std::vector<std::string> named;
  std::optional<std::string> baseline;
  std::optional<std::string> write_baseline;
  std::optional<std::string> fix;
  bool diff = false;
  bool statistics = false;
  bool print_config = false;
};

/// What is printed, and what decides about the exit status.
struct Report {
  std::string text;
  FindingCounts counts;
};

void declare(CommandLine& command_line, LintWords& words) {
  command_line.arguments("INPUT...", words.named, Text::cli_arg_inputs);
  declare_checking(command_line, words.checking);
  command_line.flag_with_word("--fix", "[=all]", words.fix, Text::cli_opt_fix);
  command_line.flag("--diff", words.diff, Text::cli_opt_lint_diff);
  command_line.value("--baseline", "FILE", words.baseline, Text::cli_opt_baseline);
  command_line.value("--write-baseline", "FILE", words.write_baseline, Text::cli_opt_write_baseline);
  command_line.flag("--statistics", words.statistics, Text::cli_opt_statistics);
  command_line.flag("--print-config", words.print_config, Text::cli_opt_print_config);
}

void require_sense(LintWords const& words) {
  if (words.named.empty()) {
    throw Failure(
        {.text = Text::cli_argument_missing, .arguments = {{"argument", "INPUT"}, {"command", "lint"}}});
  }
  bool const countable =
      words.checking.format == FindingFormat::text || words.checking.format == FindingFormat::json;
  if (words.statistics && !countable) throw Failure({.text = Text::cli_statistics_format, .arguments = {}});
}

bool names_language(std::span<std::string const> arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](std::string const& word) { return word.substr(0, 6) == "--lang"; });
}

FixChoice fix_choice(LintWords const& words) {
  if (!words.fix) return words.diff ? FixChoice::safe : FixChoice::none;
  if (words.fix->empty()) return FixChoice::safe;
  if (*words.fix == "all") return FixChoice::all;
  throw Failure({.text = Text::cli_bad_choice,
                 .arguments = {{"option", "--fix"}, {"value", *words.fix}, {"choices", "all"}}});
}

/// One lint: the words of the command line, and what they lead to.
class Lint {
 public:
  Lint(LintWords const& words, Language language, bool color)
      : words_(words), settings_(words.checking.schema_files) {
    job_.options = check_options(words.checking);
    job_.quiet = words.checking.quiet;
    job_.settings = &settings_;
    job_.write = {.language = language, .color = color};
    choice_ = fix_choice(words);
    if (words.baseline) baseline_ = Baseline::read(*words.baseline);
  }

  /// The language that the first input's settings ask for; the command line's own is asked for elsewhere.
  [[nodiscard]] std::optional<Language> language_of_settings() {
    auto const settings = settings_.find(words_.named.front());
    return settings ? settings->language : std::nullopt;
  }
  void speak(Language language) { job_.write.language = language; }

  [[nodiscard]] ExitStatus print_settings(Streams& streams) {
    for (auto const& path : expand_inputs(words_.named).paths) {
      streams.out.write(describe_settings(path, job_.options, settings_.schema_files(), settings_.find(path),
                                          job_.write.language));
    }
    return ExitStatus::success;
  }

  [[nodiscard]] ExitStatus run(Streams& streams) {
    auto inputs = expand_inputs(words_.named);
    job_.text_at_once =
        words_.checking.format == FindingFormat::text && !words_.baseline && !words_.write_baseline;
    auto const fixed = choice_ == FixChoice::none ? FixedInputs{} : apply_fixes(inputs.paths, streams.out);
    auto results = check_inputs(job_, inputs.paths, thread_count(words_.checking));
    for (auto const& checked : results) {
      if (checked.failure) inputs.failures.push_back(*checked.failure);
    }
    for (auto const& failure : inputs.failures) streams.err.write(failure.line(job_.write.language));
    sum_up_files(results);
    auto const report = job_.text_at_once ? report_texts(results) : report_findings(results, inputs.failures);
    bool const out_is_taken = words_.diff || (fixed.edited.contains("-") && choice_ != FixChoice::none);
    (out_is_taken ? streams.err : streams.out).write(report.text);
    if (!inputs.failures.empty()) return ExitStatus::failure;
    // Nothing was written: what the patch repairs still stands in the files.
    return would_change_ || objectionable(words_.checking, report.counts) ? ExitStatus::findings
                                                                          : ExitStatus::success;
  }

 private:
  /// Writes what the fixes make of the files, or shows it.
  FixedInputs apply_fixes(std::vector<std::string> const& paths, Console& out) {
    auto fixed = fix_inputs(job_, paths, choice_, baseline_);
    for (auto const& [path, before] : fixed.original) {
      auto const& after = fixed.edited.at(path);
      if (words_.diff) {
        out.write(unified_diff(path, before, after));
        would_change_ = would_change_ || before != after;
      } else if (path == "-") {
        out.write(after);
      } else if (after != before) {
        OutputFile file(path);
        file.write(after);
        file.commit();
      }
    }
    run_.fixes = fixed.facts;
    if (words_.diff) run_.fixes->applied = 0;
    job_.edited = fixed.edited;
    return fixed;
  }

  void sum_up_files(std::vector<Checked> const& results) {
    for (auto const& checked : results) files_.insert(checked.files.begin(), checked.files.end());
    run_.files = files_.size();
    run_.statistics = words_.statistics;
  }

  Report report_texts(std::vector<Checked> const& results) const {
    Report report;
    std::map<Code, CodeCount> codes;
    for (auto const& checked : results) {
      report.counts.errors += checked.counts.errors;
      report.counts.warnings += checked.counts.warnings;
      report.counts.notes += checked.counts.notes;
      report.text += checked.text;
      for (auto const& row : checked.codes) {
        auto& sum = codes[row.code];
        sum = {.code = row.code,
               .name = row.name,
               .count = sum.count + row.count,
               .fixable = sum.fixable + row.fixable};
      }
    }
    std::vector<CodeCount> rows;
    rows.reserve(codes.size());
    for (auto const& [code, row] : codes) rows.push_back(row);
    most_frequent_first(rows);
    report.text += end_of_text(rows, report.counts);
    return report;
  }

  Report report_findings(std::vector<Checked>& results, std::vector<Failure> const& failures) {
    auto all = collect(results);
    if (words_.baseline || words_.write_baseline) apply_baseline(all, !failures.empty());
    auto context = report_context(words_.named);
    for (auto const& failure : failures) context.failures.push_back(failure.sentence(job_.write.language));
    Report report{.text = {}, .counts = count(all.findings)};
    report.text = document_of(words_.checking.format, all.findings, all.sources, run_, context, job_.write);
    if (words_.checking.format == FindingFormat::text) {
      report.text += end_of_text(count_codes(all.findings), report.counts);
    }
    return report;
  }

  [[nodiscard]] std::string end_of_text(std::vector<CodeCount> const& codes,
                                        FindingCounts const& counts) const {
    std::string text;
    if (words_.statistics && !codes.empty()) text += write_text_statistics(codes, job_.write) + "\n";
    if (words_.checking.quiet || run_.files == 0) return text;
    return text + write_text_facts(run_, job_.write) + write_text_summary(run_.files, counts, job_.write);
  }

  void apply_baseline(Collected& all, bool incomplete) {
    BaselineFacts facts;
    if (words_.write_baseline) {
      baseline_ = Baseline(all.findings, all.sources);
      write_baseline();
      facts.recorded = baseline_.size();
    } else if (!incomplete) {
      facts.stale = baseline_.stale(all.findings, all.sources);
      std::erase_if(facts.stale, [this](Identity const& identity) { return !is_judged(identity.code); });
    }
    facts.hidden = baseline_.hide(all.findings, all.sources);
    run_.baseline = std::move(facts);
  }

  void write_baseline() const {
    refuse_overwriting(*words_.write_baseline, {files_.begin(), files_.end()});
    OutputFile file(*words_.write_baseline);
    file.write(baseline_.text());
    file.commit();
  }

  /// What this run does not look for cannot be missing.
  [[nodiscard]] bool is_judged(Code code) const {
    auto const* const rule = validator::find_rule(code);
    if (rule == nullptr) return true;
    bool const shown = rule->severity != Severity::note || (job_.options.pedantic && !words_.checking.quiet);
    auto const& disabled = job_.options.disabled;
    return shown && std::find(disabled.begin(), disabled.end(), code) == disabled.end();
  }

  LintWords const& words_;
  SettingsFinder settings_;
  CheckJob job_;
  FixChoice choice_ = FixChoice::none;
  bool would_change_ = false;
  Baseline baseline_;
  std::set<std::string> files_;
  RunFacts run_;
};

}  // namespace

ExitStatus lint(Invocation const& invocation) {
  LintWords words;
  CommandLine command_line("lint", Text::cli_lint_purpose, Text::cli_lint_examples, invocation.language);
  declare(command_line, words);
  if (auto const text = command_line.read(invocation.arguments)) {
    invocation.streams.out.write(*text);
    return ExitStatus::success;
  }
  require_sense(words);
  Lint lint(words, invocation.language, use_color(command_line.color(), 1));
  if (auto const language = lint.language_of_settings(); language && !names_language(invocation.arguments)) {
    lint.speak(*language);
  }
  return words.print_config ? lint.print_settings(invocation.streams) : lint.run(invocation.streams);
}

}  // namespace axisc::cli
