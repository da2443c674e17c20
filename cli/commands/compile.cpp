#include "axisc/checking/depfile.hpp"
#include "axisc/checking/ordered_work.hpp"
#include "axisc/checking/report_context.hpp"
#include "axisc/checking/report_stream.hpp"
#include "axisc/checking/written_image.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/compile_inputs.hpp"
#include "cli/options/compile_options.hpp"
#include "cli/options/named_files.hpp"
#include "cli/terminal/printed_width.hpp"
#include "cli/terminal/progress.hpp"

#include <array>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence compiled{"{file}: written, axes: {axes}, filters: {filters}, {bytes} bytes",
                            "{file}: geschrieben, Achsen: {axes}, Filter: {filters}, {bytes} Bytes"};

constexpr Sentence unchanged{"{file}: unchanged, axes: {axes}, filters: {filters}, {bytes} bytes",
                             "{file}: unverändert, Achsen: {axes}, Filter: {filters}, {bytes} Bytes"};
constexpr Sentence no_image{
    "no image was written: no input is an axis list or a machine; name the folder or the files of a machine",
    "es wurde kein Abbild geschrieben: keine Eingabe ist eine Achsliste oder eine Maschine; den Ordner oder "
    "die Dateien einer Maschine angeben"};
constexpr Sentence batch_done{
    "images: {written} written, {unchanged} unchanged, {missing} not written",
    "Abbilder: {written} geschrieben, {unchanged} unverändert, {missing} nicht geschrieben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

std::string summary(WrittenImage const& image, std::string const& path, Language language) {
  return render({image.fate == ImageFate::written ? says::compiled : says::unchanged,
                 {{"file", path},
                  {"axes", std::to_string(image.axes)},
                  {"filters", std::to_string(image.filters)},
                  {"bytes", std::to_string(image.bytes)}}},
                language) +
         "\n";
}

/// One execution of `axisc compile`.
class Compile {
 public:
  Compile(CompileOptions const& options, Language language, bool color, Streams& streams)
      : options_(options),
        streams_(streams),
        workspace_({.options = check_options(options.checking),
                    .quiet = options.checking.quiet,
                    .schema_files = options.checking.schema_files}),
        threads_(asked_threads(options.checking.threads)),
        job_{.workspace = workspace_,
             .checking = options.checking,
             .image = image_options(options),
             .language = language,
             .designs = designs_,
             .skips_other_lists = options.is_batch()} {
    report_format_.format = options.checking.format;
    report_format_.write = {.language = language, .color = color, .width = printed_width()};
    auto [inputs, images] = choose_inputs(options, workspace_);
    workspace_.take(inputs);
    paths_ = std::move(inputs.paths);
    names_ = std::move(images);
    name_failures_ = std::move(inputs.failures);
    notes_ = std::move(inputs.notes);
    sources_ = std::move(inputs.sources);
    if (needs_context(report_format_.format)) {
      report_format_.context = report_context(paths_.empty() ? std::string() : paths_.front());
    }
  }

  [[nodiscard]] ExitStatus run() {
    for (auto const& path : paths_) add_settings_files(workspace_.settings(), path, sources_);
    protect_sources();
    ReportStream report({.report_format = report_format_,
                         .quiet = options_.checking.quiet,
                         .statistics = false,
                         .counts_always = false,
                         .baseline = {},
                         .write_baseline = false,
                         .identity_paths = &identity_paths_},
                        [this](std::string_view text) { streams_.err.write(text); });
    if (!options_.checking.quiet) streams_.err.write(note_lines(notes_, job_.language));
    for (auto const& failure : name_failures_) fail(report, failure);
    compile_all(report);
    require_images(report);
    report.finish({}, [](Code) { return true; });
    streams_.err.write(failure_lines_);
    print_summary();
    return exit_status();
  }

 private:
  /// Known before anything is written: an image of one input must not replace a list of another one.
  void protect_sources() const {
    auto outputs = names_;
    if (options_.depfile) outputs.push_back(*options_.depfile);
    refuse_overwriting(outputs, sources_);
  }

  [[nodiscard]] ExitStatus exit_status() const {
    if (failed_) return ExitStatus::failure;
    return fates_[static_cast<std::size_t>(ImageFate::missing)] > 0 ? ExitStatus::findings
                                                                    : ExitStatus::success;
  }

  void fail(ReportStream& report, Failure const& failure) {
    failed_ = true;
    failure_lines_ += failure.line(job_.language);
    report.fail(failure);
  }

  /// What was to become images and becomes none looks like success.
  void require_images(ReportStream& report) {
    bool const has_image = fates_[static_cast<std::size_t>(ImageFate::written)] +
                               fates_[static_cast<std::size_t>(ImageFate::unchanged)] +
                               fates_[static_cast<std::size_t>(ImageFate::missing)] >
                           0;
    if (!options_.is_batch() || has_image || failed_) return;
    fail(report, Failure({says::no_image}));
  }

  void compile_all(ReportStream& report) {
    std::optional<OutputFile> rules;
    if (options_.is_batch() && options_.depfile) rules.emplace(*options_.depfile);
    {
      Progress progress(options_.is_batch() && progress_is_seen() && !options_.checking.quiet, job_.language);
      progress.stand_aside_for(streams_.err);
      in_order<WrittenImage>({.count = paths_.size(),
                              .work = [&](std::size_t i) { return compile_one(i); },
                              .take =
                                  [&](std::size_t i, WrittenImage&& image) {
                                    take(report, i, image);
                                    if (rules) rules->write(rule_of(i, image));
                                    progress.show(i + 1, paths_.size());
                                  },
                              .weight = [](WrittenImage const& image) { return weight_of(image.checked); }},
                             thread_count(threads_, paths_.size()));
    }
    if (rules) rules->commit();
  }

  [[nodiscard]] WrittenImage compile_one(std::size_t index) {
    auto const& path = paths_[index];
    ImageTarget target{.path = names_[index], .depfile = {}, .makes_folder = options_.is_batch()};
    // A batch has one file for the rules of all images.
    if (!options_.is_batch()) target.depfile = options_.depfile;
    return write_image(compile_input(job_, path), target, more_sources(path));
  }

  /// Settings and schema files affect the result, so a build system must watch them too.
  [[nodiscard]] std::vector<std::string> more_sources(std::string const& path) {
    std::vector<std::string> files;
    add_settings_files(workspace_.settings(), path, files);
    return files;
  }

  /// A failed image keeps its rule: it must be rebuilt when one of its sources changes.
  [[nodiscard]] std::string rule_of(std::size_t index, WrittenImage const& image) const {
    if (image.fate == ImageFate::skipped) return {};
    auto sources = image.sources;
    if (image.checked.files.empty()) sources.insert(sources.begin(), paths_[index]);
    return dependency_rule(names_[index], sources);
  }

  void take(ReportStream& report, std::size_t index, WrittenImage const& image) {
    report.add(image.checked);
    if (image.checked.failure) fail(report, *image.checked.failure);
    ++fates_[static_cast<std::size_t>(image.fate)];
    if (!options_.is_batch() && image.fate != ImageFate::missing) {
      summary_ = summary(image, names_[index], job_.language);
    }
  }

  void print_summary() {
    if (options_.checking.quiet || options_.checking.format != FindingFormat::text) return;
    if (options_.is_batch()) {
      auto const number = [this](ImageFate fate) {
        return std::to_string(fates_[static_cast<std::size_t>(fate)]);
      };
      summary_ = render({says::batch_done,
                         {{"written", number(ImageFate::written)},
                          {"unchanged", number(ImageFate::unchanged)},
                          {"missing", number(ImageFate::missing)}}},
                        job_.language) +
                 "\n";
    }
    streams_.err.write(summary_);
  }

  CompileOptions const& options_;
  Streams& streams_;
  Workspace workspace_;
  IdentityPaths identity_paths_{workspace_.settings()};
  std::optional<unsigned> threads_;
  codegen::KnownDesigns designs_;
  CompileJob job_;
  ReportFormat report_format_;
  std::vector<std::string> paths_;
  std::vector<std::string> names_;  ///< of the images, by input
  std::vector<Failure> name_failures_;
  std::vector<Message> notes_;
  std::vector<std::string> sources_;    ///< that no output may replace
  std::array<std::size_t, 4> fates_{};  ///< how many images had it
  bool failed_ = false;
  std::string failure_lines_;
  std::string summary_;
};

}  // namespace

ExitStatus compile(Invocation const& invocation) {
  CompileOptions options;
  CommandLine command_line("compile", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  require_sense(command_line, options);
  Compile compile(options, invocation.language, use_color(command_line.color(), system::Stream::error),
                  invocation.streams);
  return compile.run();
}

}  // namespace axisc::cli
