#include "axisc/checking/check_input.hpp"
#include "axisc/checking/fixing.hpp"
#include "axisc/checking/identity_paths.hpp"
#include "axisc/checking/ordered_work.hpp"
#include "axisc/checking/report_context.hpp"
#include "axisc/checking/report_stream.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "axisc/workspace/changed_inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/lint_options.hpp"
#include "cli/options/named_files.hpp"
#include "cli/terminal/printed_width.hpp"
#include "cli/terminal/progress.hpp"
#include "diagnostics/writers/unified_diff.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence judged_in{
    "{file}{more} was judged in {machine}, which names it; --alone judges it by itself",
    "{file}{more} wurde in {machine} beurteilt, wo die Datei genannt ist; --alone beurteilt sie für sich"};
constexpr Sentence judged_in_with_errors{
    "{file}{more} was judged in {machine}, which has errors in other files: {errors}; `axisc lint {machine}` "
    "shows them",
    "{file}{more} wurde in {machine} beurteilt; dort haben andere Dateien Fehler: {errors}; `axisc lint "
    "{machine}` zeigt sie"};
constexpr Sentence nothing_changed{"nothing to check: no input differs from {revision}",
                                   "nichts zu prüfen: keine Eingabe unterscheidet sich von {revision}"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

bool names_language(std::span<std::string const> arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](std::string const& word) { return word.substr(0, 6) == "--lang"; });
}

Overrides overrides(CheckingOptions const& given) {
  auto options = check_options(given);
  options.machine = false;
  return {.options = std::move(options), .quiet = given.quiet, .schema_files = given.schema_files};
}

/// One execution of `axisc lint`.
class Lint {
 public:
  Lint(LintOptions const& options, Language language, bool color, Streams& streams)
      : options_(options),
        streams_(streams),
        workspace_(overrides(options.checking)),
        threads_(asked_threads(options.checking.threads)),
        inputs_(expand_inputs(
            options.named, [this](std::string const& path) { return workspace_.settings().wants(path); },
            options.hook ? NamedFiles::of_hook : NamedFiles::usual)) {
    name_standard_input();
    report_format_.format = options.checking.format;
    report_format_.write = {.language = language, .color = color, .width = printed_width()};
    workspace_.take(inputs_);
    choice_ = fix_choice(options);
    if (options.changed_since) {
      keep_changed(inputs_, changed_since(*options.changed_since), workspace_.settings());
    }
  }

  /// The language in the first input's settings; `--lang` is read elsewhere.
  [[nodiscard]] std::optional<Language> language_of_settings() {
    auto const* const settings = workspace_.settings().find(inputs_.first);
    return settings == nullptr ? std::nullopt : settings->language;
  }
  void speak(Language language) { report_format_.write.language = language; }

  [[nodiscard]] ExitStatus print_settings() {
    auto& settings = workspace_.settings();
    for (auto const& path : inputs_.paths) {
      streams_.out.write(describe_settings(path, workspace_.overrides().options, settings.schema_files(),
                                           settings.find(path), report_format_.write.language));
    }
    return ExitStatus::success;
  }

  [[nodiscard]] ExitStatus run() {
    read_standard_input();
    if (!options_.alone) workspace_.judge_in_machines(inputs_);
    prepare();
    if (options_.write_baseline) protect(inputs_.sources);
    auto plan = report_plan();
    if (choice_ != FixChoice::none) apply_fixes(plan.baseline.value_or(Baseline()));
    if (!options_.checking.quiet) {
      streams_.err.write(note_lines(inputs_.notes, report_format_.write.language));
    }
    // Standard output is used for the patch or the fixed standard input.
    bool const out_is_taken = options_.diff || fixed_standard_input_;
    Console& printed = out_is_taken ? streams_.err : streams_.out;
    ReportStream report(std::move(plan), [&printed](std::string_view text) { printed.write(text); });
    for (auto const& failure : inputs_.failures) fail(report, failure);
    check(report);
    report.finish(fixes_,
                  [this](Code code) { return is_judged(options_, workspace_.overrides().options, code); });
    if (!machine_notes_.empty()) {
      streams_.err.write(note_lines(machine_notes_, report_format_.write.language));
    }
    if (inputs_.paths.empty()) say_nothing_changed();
    if (options_.write_baseline) write_baseline(report);
    return status_of(report);
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
    workspace_.put(standard_input_, read_whole("-"));
  }

  [[nodiscard]] bool is_standard_input(std::string const& path) const { return path == standard_input_; }

  void prepare() {
    if (needs_context(report_format_.format)) report_format_.context = report_context(inputs_.first);
    // An invalid settings file ends the run before anything is printed.
    for (auto const& path : inputs_.paths) static_cast<void>(workspace_.settings().find(path));
  }

  [[nodiscard]] ReportPlan report_plan() {
    ReportPlan plan{.report_format = report_format_,
                    .quiet = options_.checking.quiet,
                    .statistics = options_.statistics,
                    .counts_always = true,
                    .baseline = {},
                    .write_baseline = options_.write_baseline.has_value(),
                    .identity_paths = &identity_paths_};
    if (options_.baseline) plan.baseline = Baseline::read(*options_.baseline);
    return plan;
  }

  void fail(ReportStream& report, Failure const& failure) {
    failed_ = true;
    streams_.err.write(failure.line(report_format_.write.language));
    report.fail(failure);
  }

  void say_nothing_changed() {
    bool const is_for_people =
        report_format_.format == FindingFormat::text && !options_.checking.quiet && !options_.diff;
    if (!options_.changed_since || !is_for_people) return;
    streams_.out.write(render({says::nothing_changed, {{"revision", *options_.changed_since}}},
                              report_format_.write.language) +
                       "\n");
  }

  void check(ReportStream& report) {
    bool const takes_time = inputs_.paths.size() > 1;
    Progress progress(takes_time && progress_is_seen() && !options_.checking.quiet,
                      report_format_.write.language);
    progress.stand_aside_for(streams_.out);
    progress.stand_aside_for(streams_.err);
    auto const& paths = inputs_.paths;
    auto const threads = thread_count(threads_, paths.size());
    // With one thread no finding has to wait for its turn.
    bool const at_once = is_one_by_one(paths.size(), threads);
    TakeFinding const print = [&report](Finding const& finding, SourceSet const& sources) {
      report.add(finding, sources);
    };
    in_order<CheckedInput>(
        {.count = paths.size(),
         .work = [&](std::size_t i) { return check_input(workspace_, paths[i], at_once ? &print : nullptr); },
         .take =
             [&](std::size_t i, CheckedInput&& input) {
               if (input.failure) fail(report, *input.failure);
               report.add(input);
               say_machine(paths[i], input);
               progress.show(i + 1, paths.size());
             },
         .weight = weight_of},
        threads);
  }

  /// Who names a list reads what the list is judged by, and that there is more to mend.
  void say_machine(std::string const& path, CheckedInput const& input) {
    auto const shown = inputs_.shown.find(path);
    bool const is_for_people = report_format_.format == FindingFormat::text && !options_.checking.quiet;
    if (shown == inputs_.shown.end() || !is_for_people || options_.stdin_filename) return;
    auto const& names = shown->second;
    auto const errors = input.elsewhere.errors;
    machine_notes_.push_back(
        {errors == 0 ? says::judged_in : says::judged_in_with_errors,
         {{"machine", path},
          {"file", names.front()},
          {"more", names.size() == 1 ? std::string() : " +" + std::to_string(names.size() - 1)},
          {"errors", std::to_string(errors)}}});
  }

  [[nodiscard]] ExitStatus status_of(ReportStream const& report) const {
    if (failed_) return ExitStatus::failure;
    bool const fails = options_.fail_on != FailOn::never && objectionable(options_.checking, report.counts());
    // Nothing was written: the files still contain what the patch would fix.
    return would_change_ || fails ? ExitStatus::findings : ExitStatus::success;
  }

  /// Writes the fixed files, or prints the patch.
  void apply_fixes(Baseline const& baseline) {
    auto fixed = fix_inputs(workspace_, inputs_.paths, choice_, baseline, identity_paths_,
                            ChangeableFiles(inputs_.named));
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
    workspace_.put_all(std::move(fixed.edited));
    fixed_standard_input_ = workspace_.unsaved().contains(standard_input_);
  }

  /// The baseline must not replace what was read.
  void protect(std::vector<std::string> sources) {
    for (auto const& path : inputs_.paths) add_settings_files(workspace_.settings(), path, sources);
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
  Workspace workspace_;
  IdentityPaths identity_paths_{workspace_.settings()};
  std::optional<unsigned> threads_;
  Inputs inputs_;
  ReportFormat report_format_;
  std::string standard_input_ = "-";  ///< the name that the input has
  FixChoice choice_ = FixChoice::none;
  std::optional<FixFacts> fixes_;
  std::vector<Message> machine_notes_;
  bool would_change_ = false;
  bool fixed_standard_input_ = false;
  bool failed_ = false;
};

}  // namespace

ExitStatus lint(Invocation const& invocation) {
  LintOptions options;
  CommandLine command_line("lint", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  if (options.changed_since && options.named.empty()) options.named = {"."};
  require_sense(command_line, options);
  if (options.fail_on == FailOn::warning) options.checking.werror = true;
  Lint lint(options, invocation.language, use_color(command_line.color(), system::Stream::output),
            invocation.streams);
  if (auto const language = lint.language_of_settings(); language && !names_language(invocation.arguments)) {
    lint.speak(*language);
  }
  if (options.print_config) return lint.print_settings();
  return lint.run();
}

}  // namespace axisc::cli
