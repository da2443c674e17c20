#include "cli/checking/check_input.hpp"
#include "cli/checking/fixing.hpp"
#include "cli/checking/identity_paths.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/files/output_file.hpp"
#include "cli/files/protected_files.hpp"
#include "cli/fleet/ordered_work.hpp"
#include "cli/options/lint_options.hpp"
#include "cli/options/named_files.hpp"
#include "cli/report/report_context.hpp"
#include "cli/report/report_stream.hpp"
#include "diagnostics/writers/unified_diff.hpp"
#include "editor/machine_context.hpp"
#include "validator/engine/rule.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence purpose{
    "Checks axis lists, machine files and NC programs and prints what is wrong, and what the control would "
    "do.",
    "Prüft Achslisten, Maschinendateien und NC-Programme und zeigt, was falsch ist und was die Steuerung "
    "täte."};
constexpr Sentence examples{R"(Examples:
  axisc lint x.lis --cycle-time 1ms      one axis
  axisc lint machine.json                all axes of a machine together
  axisc lint axes/                       every list and machine file in a folder
  axisc lint x.lis --format json         for other programs; sarif, github and gitlab for code hosts
  axisc lint x.lis --fix                 applies the fixes that change nothing for the machine
  axisc lint x.lis --fix=all --diff      shows all fixes as a patch
  axisc lint . --write-baseline known.json
  axisc lint . --baseline known.json     only what is new since then
  axisc lint - --stdin-filename axes/x.lis    the text of an editor, judged in the machine of the file
  axisc lint @changed.txt                the inputs that a file names, one per line or with a NUL after each
  axisc lint . --cache ~/.cache/axisc    again, checking only what has changed
  axisc lint . --shard 2/8 --format json > 2.json    a part; `axisc merge` combines the parts

A comment `# axisc: allow AX3005` in a list silences a code on its line or, alone on a line, on the next;
`# axisc: allow-file AX3005` silences it in the whole file.

Exit status: 0 no errors, 1 errors (or warnings with --werror), 2 something could not be read.)",
                            R"(Beispiele:
  axisc lint x.lis --cycle-time 1ms      eine Achse
  axisc lint maschine.json               alle Achsen einer Maschine zusammen
  axisc lint achsen/                     jede Liste und Maschinendatei eines Ordners
  axisc lint x.lis --format json         für andere Programme; sarif, github und gitlab für Code-Plattformen
  axisc lint x.lis --fix                 korrigiert, was für die Maschine nichts ändert
  axisc lint x.lis --fix=all --diff      zeigt alle Korrekturen als Patch
  axisc lint . --write-baseline bekannt.json
  axisc lint . --baseline bekannt.json   nur, was seitdem neu ist
  axisc lint - --stdin-filename achsen/x.lis    der Text eines Editors: Einstellungen und Meldungen wie bei der Datei
  axisc lint @geaendert.txt              die Eingaben, die eine Datei nennt, eine je Zeile oder mit NUL danach
  axisc lint . --cache ~/.cache/axisc    noch einmal, prüft nur das Geänderte
  axisc lint . --shard 2/8 --format json > 2.json    ein Teil; `axisc merge` führt die Teile zusammen

Ein Kommentar `# axisc: allow AX3005` in einer Liste unterdrückt einen Code in seiner Zeile oder, allein in
einer Zeile, in der nächsten; `# axisc: allow-file AX3005` in der ganzen Datei.
Rückgabewert: 0 keine Fehler, 1 Fehler (mit --werror auch Warnungen), 2 etwas war nicht lesbar.)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

bool names_language(std::span<std::string const> arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](std::string const& word) { return word.substr(0, 6) == "--lang"; });
}

/// One execution of `axisc lint`.
class Lint {
 public:
  Lint(LintOptions const& options, Language language, bool color, Streams& streams)
      : options_(options),
        streams_(streams),
        settings_(options.checking.schema_files),
        threads_(asked_threads(options.checking.threads)),
        inputs_(expand_inputs(
            options.named, [this](std::string const& path) { return settings_.wants(path); },
            options.hook ? NamedFiles::of_hook : NamedFiles::usual)) {
    job_.options = check_options(options.checking);
    job_.options.machine = false;
    job_.quiet = options.checking.quiet;
    name_standard_input();
    job_.settings = &settings_;
    report_format_.format = options.checking.format;
    report_format_.write = {.language = language, .color = color};
    job_.found = inputs_.found;
    choice_ = fix_choice(options);
    part_ = choose_part(options.fleet, std::move(inputs_.paths));
  }

  /// The language in the first input's settings; `--lang` is read elsewhere.
  [[nodiscard]] std::optional<Language> language_of_settings() {
    auto const* const settings = settings_.find(inputs_.first);
    return settings == nullptr ? std::nullopt : settings->language;
  }
  void speak(Language language) { report_format_.write.language = language; }

  [[nodiscard]] ExitStatus print_settings() {
    for (auto const& path : part_.paths()) {
      streams_.out.write(describe_settings(path, job_.options, settings_.schema_files(), settings_.find(path),
                                           report_format_.write.language));
    }
    return ExitStatus::success;
  }

  [[nodiscard]] ExitStatus print_key() {
    prepare();
    Hasher hasher = run_options();
    hasher.digest(run_);
    if (options_.baseline) hasher.text(Baseline::read(*options_.baseline).text());
    for (auto const& path : part_.paths()) add_files(hasher, job_, path);
    streams_.out.write(hexadecimal(hasher.finish()) + "\n");
    return ExitStatus::success;
  }

  [[nodiscard]] ExitStatus run() {
    read_standard_input();
    prepare();
    if (options_.write_baseline) protect(inputs_.sources);
    auto plan = report_plan();
    if (choice_ != FixChoice::none) apply_fixes(plan.baseline.value_or(Baseline()));
    if (!options_.checking.quiet) {
      streams_.err.write(note_lines(inputs_.notes, report_format_.write.language));
    }
    // Standard output is used for the patch or the fixed standard input.
    bool const out_is_taken = options_.diff || fixed_standard_input_;
    ReportStream report(std::move(plan), out_is_taken ? streams_.err : streams_.out);
    for (std::size_t i = 0; i < inputs_.failures.size(); ++i) {
      if (reports_names(part_)) fail(report, i, inputs_.failures[i]);
    }
    check(report);
    auto const status = status_of(report);
    report.finish(
        fixes_, [this](Code code) { return is_judged(options_, job_.options, code); },
        static_cast<int>(status));
    if (options_.write_baseline) write_baseline(report);
    return status;
  }

 private:
  void name_standard_input() {
    if (!options_.stdin_filename) return;
    standard_input_ = validator::key_of(*options_.stdin_filename);
    std::replace(inputs_.paths.begin(), inputs_.paths.end(), std::string("-"), standard_input_);
    if (inputs_.first == "-") inputs_.first = standard_input_;
  }

  /// An editor's text takes the place of the file. Without a name the check reads it like a file.
  void read_standard_input() {
    if (!options_.stdin_filename) return;
    job_.edited.emplace(standard_input_, read_whole("-"));
  }

  [[nodiscard]] bool is_standard_input(std::string const& path) const { return path == standard_input_; }

  void prepare() {
    if (needs_context(report_format_.format)) report_format_.context = report_context(inputs_.first);
    if (options_.fleet.asks_for_digests()) run_ = run_digest(job_, report_format_);
    // An invalid settings file ends the run before anything is printed.
    for (auto const& path : part_.paths()) static_cast<void>(settings_.find(path));
  }

  /// Options that affect the whole run, not its inputs.
  [[nodiscard]] Hasher run_options() const {
    Hasher hasher;
    hasher.text("lint");
    hasher.number(options_.checking.werror ? 1 : 0);
    hasher.number(options_.statistics ? 1 : 0);
    hasher.number(static_cast<std::uint64_t>(choice_));
    hasher.number(options_.diff ? 1 : 0);
    hasher.number(options_.write_baseline ? 1 : 0);
    return hasher;
  }

  [[nodiscard]] ReportPlan report_plan() {
    ReportPlan plan{.report_format = report_format_,
                    .quiet = options_.checking.quiet,
                    .statistics = options_.statistics,
                    .counts_always = true,
                    .baseline = {},
                    .write_baseline = options_.write_baseline.has_value(),
                    .shard = shard_record(part_, run_options(), run_, job_, options_.checking.werror),
                    .identity_paths = &identity_paths_};
    if (options_.baseline) plan.baseline = Baseline::read(*options_.baseline);
    if (!plan.shard) return plan;
    for (auto const& rule : validator::rules()) {
      if (is_judged(options_, job_.options, rule.code)) continue;
      plan.shard->unjudged.push_back(static_cast<unsigned>(rule.code));
    }
    return plan;
  }

  void fail(ReportStream& report, std::size_t order, Failure const& failure) {
    failed_ = true;
    streams_.err.write(failure.line(report_format_.write.language));
    report.fail(order, failure);
  }

  void check(ReportStream& report) {
    // The fixed content of a file is not on the disk yet.
    auto cache = choice_ == FixChoice::none
                     ? open_cache(options_.fleet, streams_.err, report_format_.write.language)
                     : nullptr;
    bool const takes_time = part_.chosen.size() > 1;
    Progress progress(takes_time && progress_is_seen() && !options_.checking.quiet,
                      report_format_.write.language);
    progress.stand_aside_for(streams_.out);
    progress.stand_aside_for(streams_.err);
    auto const threads = thread_count(threads_, part_.chosen.size());
    // With one thread no finding has to wait for its turn.
    bool const at_once = cache == nullptr && is_one_by_one(part_.chosen.size(), threads);
    auto const print = [&report](WrittenFinding const& finding) { report.add(finding); };
    in_order<CheckedInput>({.count = part_.chosen.size(),
                            .work =
                                [&](std::size_t i) {
                                  auto const& path = part_.path(i);
                                  return at_once ? checked(path, print) : checked(path, cache.get());
                                },
                            .take =
                                [&](std::size_t i, CheckedInput&& input) {
                                  auto const number = part_.chosen[i];
                                  if (input.failure) {
                                    fail(report, inputs_.failures.size() + number, *input.failure);
                                  }
                                  report.add(number, input);
                                  progress.show(i + 1, part_.chosen.size());
                                },
                            .weight = weight_of},
                           threads);
    finish_cache(std::move(cache), options_.fleet, streams_.err, report_format_.write.language);
  }

  /// An editor's text is judged in the machine that its file belongs to. Fixes are made in the text alone.
  [[nodiscard]] CheckedInput check_text(TakeFinding const& take) const {
    EditedFiles files(job_.edited, false);
    CheckJob job = job_;
    auto const machine = editor::machine_of(
        files, standard_input_, [this](std::string const& path) { return options_for(job_, path); });
    if (machine != standard_input_) job.shown = standard_input_;
    return check_input(job, machine, files, report_format_, take);
  }
  [[nodiscard]] bool is_text_of_machine(std::string const& path) const {
    return options_.stdin_filename && is_standard_input(path) && choice_ == FixChoice::none;
  }

  [[nodiscard]] CheckedInput checked(std::string const& path, TakeFinding const& take) const {
    if (is_text_of_machine(path)) return check_text(take);
    EditedFiles files(job_.edited, path == "-");
    return check_input(job_, path, files, report_format_, take);
  }

  [[nodiscard]] CheckedInput checked(std::string const& path, ResultCache* cache) const {
    if (is_text_of_machine(path)) {
      std::deque<WrittenFinding> findings;
      auto result = check_text(keep_in(findings));
      result.findings = std::move(findings);
      return result;
    }
    if (cache == nullptr || is_standard_input(path)) {
      EditedFiles files(job_.edited, path == "-");
      return check_input(job_, path, files, report_format_);
    }
    CachedInput cached(*cache, input_digest(run_, job_, path), path);
    if (auto const known = cached.find()) {
      ByteReader bytes(*known);
      if (auto result = read_checked_input(bytes)) return *std::move(result);
    }
    auto result = check_input(job_, path, cached.files(), report_format_);
    if (!result.failure) {
      ByteWriter bytes;
      write_bytes(bytes, result);
      cached.keep(std::move(bytes).take());
    }
    return result;
  }

  [[nodiscard]] ExitStatus status_of(ReportStream const& report) const {
    if (failed_) return ExitStatus::failure;
    // Nothing was written: the files still contain what the patch would fix.
    return would_change_ || objectionable(options_.checking, report.counts()) ? ExitStatus::findings
                                                                              : ExitStatus::success;
  }

  /// Writes the fixed files, or prints the patch.
  void apply_fixes(Baseline const& baseline) {
    auto fixed =
        fix_inputs(job_, part_.paths(), choice_, baseline, identity_paths_, ChangeableFiles(inputs_.named));
    for (auto const& [path, before] : fixed.original) {
      auto const& after = fixed.edited.at(path);
      if (options_.diff) {
        streams_.out.write(unified_diff(path, before, after));
        would_change_ = would_change_ || before != after;
      } else if (is_standard_input(path)) {
        streams_.out.write(after);
      } else if (after != before) {
        replace_content(path, before, after);
      }
    }
    fixes_ = fixed.facts;
    if (options_.diff) {
      fixes_->applied = 0;
      fixes_->named.clear();
    }
    job_.edited = std::move(fixed.edited);
    fixed_standard_input_ = choice_ != FixChoice::none && job_.edited.contains(standard_input_);
  }

  /// The baseline must not replace what was read.
  void protect(std::vector<std::string> sources) {
    for (auto const& path : part_.paths()) add_settings_files(settings_, path, sources);
    refuse_overwriting({*options_.write_baseline}, sources);
  }

  void write_baseline(ReportStream const& report) {
    protect({report.files().begin(), report.files().end()});
    OutputFile file(*options_.write_baseline);
    file.write(report.found().text());
    file.commit();
  }

  LintOptions const& options_;
  Streams& streams_;
  SettingsFinder settings_;
  IdentityPaths identity_paths_{settings_};
  std::optional<unsigned> threads_;
  Inputs inputs_;
  Part part_;
  CheckJob job_;
  ReportFormat report_format_;
  Digest run_;
  std::string standard_input_ = "-";  ///< the name that the input has
  FixChoice choice_ = FixChoice::none;
  std::optional<FixFacts> fixes_;
  bool would_change_ = false;
  bool fixed_standard_input_ = false;
  bool failed_ = false;
};

}  // namespace

ExitStatus lint(Invocation const& invocation) {
  LintOptions options;
  CommandLine command_line("lint", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  require_sense(command_line, options);
  Lint lint(options, invocation.language, use_color(command_line.color(), system::Stream::output),
            invocation.streams);
  if (auto const language = lint.language_of_settings(); language && !names_language(invocation.arguments)) {
    lint.speak(*language);
  }
  if (options.print_config) return lint.print_settings();
  return options.fleet.print_key ? lint.print_key() : lint.run();
}

}  // namespace axisc::cli
