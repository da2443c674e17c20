#include "axisrt.h"
#include "cli/checking/depfile.hpp"
#include "cli/checking/written_image.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/output_file.hpp"
#include "cli/files/protected_files.hpp"
#include "cli/fleet/ordered_work.hpp"
#include "cli/options/compile_inputs.hpp"
#include "cli/options/compile_options.hpp"
#include "cli/options/named_files.hpp"
#include "cli/report/report_context.hpp"
#include "cli/report/report_stream.hpp"
#include "codegen/aligned_bytes.hpp"

#include <array>
#include <span>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Checks axis lists or machine files and writes a coefficient image for each. With errors nothing is written, and
an old image stays as it is.)",
    R"(Prüft Achslisten oder Maschinendateien und schreibt je eines ihr Koeffizientenabbild. Bei Fehlern wird nichts
geschrieben, ein altes Abbild bleibt unverändert.)"};
constexpr Sentence examples{R"(Examples:
  axisc compile machine.json -o mill.axim
  axisc compile x.lis -o x.axim --cycle-time 250us
  axisc compile machine.json -o mill.axim --strip --image-version 7
  axisc compile machine.json -o mill.axim --depfile mill.d
  axisc compile plant/ --output-folder images     plant/a/x.lis becomes images/plant/a/x.axim
  axisc compile @lists.txt --output-folder images --cache ~/.cache/axisc --shard 2/8

An image that would not change is left untouched, so that build systems rebuild nothing that depends on it.
Equal inputs give the same bytes, wherever they are. Findings go to standard error.

Exit status: 0 written, 1 errors (or warnings with --werror), 2 something could not be read or written.)",
                            R"(Beispiele:
  axisc compile maschine.json -o fraese.axim
  axisc compile x.lis -o x.axim --cycle-time 250us
  axisc compile maschine.json -o fraese.axim --strip --image-version 7
  axisc compile maschine.json -o fraese.axim --depfile fraese.d
  axisc compile werk/ --output-folder abbilder    werk/a/x.lis wird abbilder/werk/a/x.axim
  axisc compile @listen.txt --output-folder abbilder --cache ~/.cache/axisc --shard 2/8

Ein Abbild, das sich nicht ändern würde, bleibt unberührt; Build-Systeme bauen dann nichts davon Abhängiges neu.
Gleiche Eingaben ergeben dieselben Bytes, wo immer sie liegen. Befunde gehen auf die Standardfehlerausgabe.

Rückgabewert: 0 geschrieben, 1 Fehler (mit --werror auch Warnungen), 2 etwas war nicht les- oder schreibbar.)"};
constexpr Sentence compiled{"{file}: written, axes: {axes}, filters: {filters}, {bytes} bytes",
                            "{file}: geschrieben, Achsen: {axes}, Filter: {filters}, {bytes} Bytes"};

constexpr Sentence unchanged{"{file}: unchanged, axes: {axes}, filters: {filters}, {bytes} bytes",
                             "{file}: unverändert, Achsen: {axes}, Filter: {filters}, {bytes} Bytes"};
constexpr Sentence no_image{
    "no image was written: no input is an axis list or a machine; name the folder or the files of a machine",
    "es wurde kein Abbild geschrieben: keine Eingabe ist eine Achsliste oder eine Maschine; den Ordner oder "
    "die "
    "Dateien einer Maschine angeben"};
constexpr Sentence batch_done{
    "images: {written} written, {unchanged} unchanged, {missing} not written",
    "Abbilder: {written} geschrieben, {unchanged} unverändert, {missing} nicht geschrieben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

std::string summary(WrittenImage const& image, std::string const& path, Language language) {
  return render({.sentence = image.fate == ImageFate::written ? says::compiled : says::unchanged,
                 .arguments = {{"file", path},
                               {"axes", std::to_string(image.axes)},
                               {"filters", std::to_string(image.filters)},
                               {"bytes", std::to_string(image.bytes)}}},
                language) +
         "\n";
}

/// A cache may lie where others write: an image from it is verified like one from anywhere else.
bool is_sound(CompiledInput const& cached) {
  if (!cached.image) return true;
  codegen::AlignedBytes const bytes(std::as_bytes(std::span(cached.image->bytes)));
  return axisrt_verify(bytes.data(), bytes.size()) == AXISRT_OK;
}

/// One execution of `axisc compile`.
class Compile {
 public:
  Compile(CompileOptions const& options, Language language, bool color, Streams& streams)
      : options_(options),
        streams_(streams),
        settings_(options.checking.schema_files),
        threads_(asked_threads(options.checking.threads)),
        job_{.check = {},
             .checking = options.checking,
             .image = image_options(options),
             .report_format = {},
             .designs = designs_,
             .skips_other_lists = options.is_batch()} {
    job_.check.options = check_options(options.checking);
    job_.check.quiet = options.checking.quiet;
    job_.check.settings = &settings_;
    job_.report_format.format = options.checking.format;
    job_.report_format.write = {.language = language, .color = color};
    auto inputs = choose_inputs(options, settings_);
    job_.check.found = std::move(inputs.found);
    part_ = std::move(inputs.part);
    names_ = std::move(inputs.images);
    name_failures_ = std::move(inputs.failures);
    notes_ = std::move(inputs.notes);
    sources_ = std::move(inputs.sources);
    if (needs_context(job_.report_format.format)) {
      job_.report_format.context = report_context(part_.all.empty() ? std::string() : part_.all.front());
    }
    if (options.fleet.asks_for_digests()) run_ = image_digest();
  }

  [[nodiscard]] ExitStatus print_key() {
    Hasher hasher;
    hasher.digest(run_);
    for (auto const& path : part_.paths()) add_files(hasher, job_.check, path);
    streams_.out.write(hexadecimal(hasher.finish()) + "\n");
    return ExitStatus::success;
  }

  [[nodiscard]] ExitStatus run() {
    for (auto const& path : part_.paths()) add_settings_files(settings_, path, sources_);
    protect_sources();
    ReportStream report({.report_format = job_.report_format,
                         .quiet = options_.checking.quiet,
                         .statistics = false,
                         .counts_always = false,
                         .baseline = {},
                         .write_baseline = false,
                         .shard = shard_record(part_, {}, run_, job_.check, options_.checking.werror),
                         .identity_paths = &identity_paths_},
                        streams_.err);
    if (!options_.checking.quiet) {
      streams_.err.write(note_lines(notes_, job_.report_format.write.language));
    }
    for (std::size_t i = 0; i < name_failures_.size(); ++i) {
      if (reports_names(part_)) fail(report, i, name_failures_[i]);
    }
    compile_all(report);
    require_images(report);
    auto const status = exit_status();
    report.finish(
        {}, [](Code) { return true; }, static_cast<int>(status));
    streams_.err.write(failure_lines_);
    print_summary();
    return status;
  }

 private:
  /// Known before anything is written: an image of one input must not replace a list of another one.
  void protect_sources() const {
    std::vector<std::string> outputs;
    for (auto const index : part_.chosen) outputs.push_back(names_[index]);
    if (options_.depfile) outputs.push_back(*options_.depfile);
    refuse_overwriting(outputs, sources_);
  }

  [[nodiscard]] ExitStatus exit_status() const {
    if (failed_) return ExitStatus::failure;
    return fates_[static_cast<std::size_t>(ImageFate::missing)] > 0 ? ExitStatus::findings
                                                                    : ExitStatus::success;
  }

  /// Everything but the input that an image and its messages depend on.
  [[nodiscard]] Digest image_digest() const {
    Hasher hasher;
    hasher.text("compile");
    hasher.digest(run_digest(job_.check, job_.report_format));
    hasher.number(options_.checking.werror ? 1 : 0);
    hasher.number(job_.image.strip ? 1 : 0);
    hasher.number(job_.image.image_version);
    return hasher.finish();
  }

  void fail(ReportStream& report, std::size_t order, Failure const& failure) {
    failed_ = true;
    failure_lines_ += failure.line(job_.report_format.write.language);
    report.fail(order, failure);
  }

  /// What was to become images and becomes none looks like success. A part of a batch may be empty.
  void require_images(ReportStream& report) {
    bool const is_part = part_.chosen.empty() && !part_.all.empty();
    bool const has_image = fates_[static_cast<std::size_t>(ImageFate::written)] +
                               fates_[static_cast<std::size_t>(ImageFate::unchanged)] +
                               fates_[static_cast<std::size_t>(ImageFate::missing)] >
                           0;
    if (!options_.is_batch() || is_part || has_image || failed_) return;
    fail(report, name_failures_.size() + part_.all.size(),
         Failure({.sentence = says::no_image, .arguments = {}}));
  }

  void compile_all(ReportStream& report) {
    auto cache = open_cache(options_.fleet, streams_.err, job_.report_format.write.language);
    std::optional<OutputFile> rules;
    if (options_.is_batch() && options_.depfile) rules.emplace(*options_.depfile);
    {
      Progress progress(options_.is_batch() && progress_is_seen() && !options_.checking.quiet,
                        job_.report_format.write.language);
      progress.stand_aside_for(streams_.err);
      in_order<WrittenImage>({.count = part_.chosen.size(),
                              .work = [&](std::size_t i) { return compile_one(i, cache.get()); },
                              .take =
                                  [&](std::size_t i, WrittenImage&& image) {
                                    take(report, i, image);
                                    if (rules) rules->write(rule_of(i, image));
                                    progress.show(i + 1, part_.chosen.size());
                                  },
                              .weight = [](WrittenImage const& image) { return weight_of(image.checked); }},
                             thread_count(threads_, part_.chosen.size()));
    }
    if (rules) rules->commit();
    finish_cache(std::move(cache), options_.fleet, streams_.err, job_.report_format.write.language);
  }

  [[nodiscard]] WrittenImage compile_one(std::size_t index, ResultCache* cache) {
    auto const& path = part_.path(index);
    ImageTarget target{
        .path = names_[part_.chosen[index]], .depfile = {}, .makes_folder = options_.is_batch()};
    // A batch has one file for the rules of all images.
    if (!options_.is_batch()) target.depfile = options_.depfile;
    return write_image(compiled(path, cache), target, more_sources(path));
  }

  [[nodiscard]] CompiledInput compiled(std::string const& path, ResultCache* cache) const {
    if (cache == nullptr || path == "-") {
      DiskFiles files(path == "-");
      return compile_input(job_, path, files);
    }
    CachedInput cached(*cache, input_digest(run_, job_.check, path), path);
    if (auto const known = cached.find()) {
      if (auto result = read_compiled_input(*known); result && is_sound(*result)) return *std::move(result);
    }
    auto result = compile_input(job_, path, cached.files());
    if (!result.checked.failure) cached.keep(to_bytes(result));
    return result;
  }

  /// Settings and schema files affect the result, so a build system must watch them too.
  [[nodiscard]] std::vector<std::string> more_sources(std::string const& path) {
    std::vector<std::string> files;
    add_settings_files(settings_, path, files);
    return files;
  }

  /// A failed image keeps its rule: it must be rebuilt when one of its sources changes.
  [[nodiscard]] std::string rule_of(std::size_t index, WrittenImage const& image) const {
    if (image.fate == ImageFate::skipped) return {};
    auto sources = image.sources;
    if (image.checked.files.empty()) sources.insert(sources.begin(), part_.path(index));
    return dependency_rule(names_[part_.chosen[index]], sources);
  }

  void take(ReportStream& report, std::size_t index, WrittenImage const& image) {
    auto const number = part_.chosen[index];
    report.add(number, image.checked);
    if (image.checked.failure) fail(report, name_failures_.size() + number, *image.checked.failure);
    ++fates_[static_cast<std::size_t>(image.fate)];
    if (!options_.is_batch() && image.fate != ImageFate::missing) {
      summary_ = summary(image, names_[number], job_.report_format.write.language);
    }
  }

  void print_summary() {
    if (options_.checking.quiet || options_.checking.format != FindingFormat::text) return;
    if (options_.is_batch()) {
      auto const number = [this](ImageFate fate) {
        return std::to_string(fates_[static_cast<std::size_t>(fate)]);
      };
      summary_ = render({.sentence = says::batch_done,
                         .arguments = {{"written", number(ImageFate::written)},
                                       {"unchanged", number(ImageFate::unchanged)},
                                       {"missing", number(ImageFate::missing)}}},
                        job_.report_format.write.language) +
                 "\n";
    }
    streams_.err.write(summary_);
  }

  CompileOptions const& options_;
  Streams& streams_;
  SettingsFinder settings_;
  IdentityPaths identity_paths_{settings_};
  std::optional<unsigned> threads_;
  codegen::KnownDesigns designs_;
  CompileJob job_;
  Part part_;
  std::vector<std::string> names_;  ///< of the images, by input
  std::vector<Failure> name_failures_;
  std::vector<Message> notes_;
  std::vector<std::string> sources_;  ///< that no output may replace
  Digest run_;
  std::array<std::size_t, 4> fates_{};  ///< how many images had it
  bool failed_ = false;
  std::string failure_lines_;
  std::string summary_;
};

}  // namespace

ExitStatus compile(Invocation const& invocation) {
  CompileOptions options;
  CommandLine command_line("compile", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  require_sense(command_line, options);
  Compile compile(options, invocation.language, use_color(command_line.color(), system::Stream::error),
                  invocation.streams);
  return options.fleet.print_key ? compile.print_key() : compile.run();
}

}  // namespace axisc::cli
