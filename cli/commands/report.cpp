#include "cli/checking/compilable.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/contour_words.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/comparison/machine_difference.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/files/named_files.hpp"
#include "cli/files/output_file.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/files/protected_files.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/inputs.hpp"
#include "cli/options/report_format.hpp"
#include "cli/report_page/report_page.hpp"
#include "cli/sentences.hpp"

#include <algorithm>
#include <memory>

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Writes one self-contained page about a machine: what is wrong, what its lists set, what each filter does to its
axis, delays and contours of each channel, what its programs do, and with --before every change with its effect. It opens without a network and
without scripts, and prints on A4. After errors the page holds the findings alone.)",
    R"(Schreibt eine eigenständige Seite über eine Maschine: was falsch ist, was ihre Listen setzen, was jeder Filter mit
seiner Achse macht, Verzögerungen und Konturen jedes Kanals, was seine Programme machen, und mit --before jede Änderung mit ihrer Wirkung. Sie öffnet
ohne Netz und ohne Skripte und lässt sich auf A4 drucken. Nach Fehlern enthält die Seite nur die Befunde.)"};
constexpr Sentence examples{R"(Examples:
  axisc report listen/ -o report.html
  axisc report listen/ --before old/listen/ -o change.html
  axisc report machine.json --feed 1000,4000 --lang de -o abnahme.html)",
                            R"(Beispiele:
  axisc report listen/ -o bericht.html
  axisc report listen/ --before alt/listen/ -o aenderung.html
  axisc report maschine.json --feed 1000,4000 -o abnahme.html)"};
constexpr Sentence argument_reported{
    "a list, a machine file, a start-up list, a project, or a folder with one machine",
    "eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt oder ein Ordner mit einer Maschine"};
constexpr Sentence option_page{"where the page goes, - for standard output",
                               "wohin die Seite geht, - für die Standardausgabe"};
constexpr Sentence option_earlier{
    "an earlier state of the same machine: adds every change and its effect",
    "ein früherer Stand derselben Maschine: dazu jede Änderung und ihre Wirkung"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct ReportOptions {
  std::optional<std::string> input, before, output, cycle_time;
  ContourWords contour;
};

void declare(CommandLine& command_line, ReportOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_reported);
  command_line.value("-o,--output", "FILE.html", options.output, says::option_page);
  command_line.value("--before", "OTHER", options.before, says::option_earlier);
  declare_contour_words(command_line, options.contour, ContourWords::Shown::shapes);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
}

/// Checks one input and keeps every finding.
validator::CheckResult check_into(ReportSubject& subject, std::string const& path, CheckJob const& job,
                                  DiskFiles& disk, SourceSet& sources) {
  std::vector<Finding> findings;
  auto result = validator::check(disk, path, options_for(job, path), sources,
                                 [&findings](Finding& finding) { findings.push_back(std::move(finding)); });
  if (result.unreadable) throw unreadable(path, *result.unreadable);
  for (auto const& finding : findings) add_finding(subject, finding, sources);
  return result;
}

/// The machine at `path`, and whatever else lies in a folder, in the order of `lint`. None after errors.
std::optional<CheckedMachine> checked(ReportSubject& subject, std::string const& path,
                                      std::vector<std::string> const& inputs, CheckJob const& job) {
  std::optional<CheckedMachine> machine;
  std::optional<Failure> refused;
  for (auto const& input : inputs) {
    auto disk = std::make_unique<DiskFiles>(input == "-");
    SourceSet sources;
    auto result = check_into(subject, input, job, *disk, sources);
    if (input != path) continue;
    refused = refusal(path, result, sources, subject.language);
    if (!result.machine) continue;
    if (!refused) require_cycle_time(path, result);
    machine.emplace(CheckedMachine{
        .disk = std::move(disk), .machine = *std::move(result.machine), .files = std::move(result.files)});
  }
  if (subject.counts.errors > 0) return std::nullopt;
  // Without a machine the page could not say that it is ready.
  if (refused) throw Failure(*refused);
  return machine;
}

/// An earlier state beside the present one.
struct Earlier {
  std::unique_ptr<ComparedMachine> before, after;
  std::optional<MachineDifference> difference = std::nullopt;
  std::optional<image::RuntimeHost> host = std::nullopt;
  std::optional<image::StepAnswers> steps = std::nullopt;

  /// Errors are printed.
  void read(ReportOptions const& options, CheckJob const& job, Invocation const& invocation, bool color) {
    before = compared_machine(*options.before, job, invocation, color);
    after = compared_machine(*options.input, job, invocation, color);
    if (!before || !after) return;
    difference.emplace(compare_machines(*before, *after, false));
    if (!before->image) return;
    host.emplace(start_runtime(*options.before, *before->image));
    steps.emplace(before->image->bytes.bytes(), before->image->contents);
  }
};

void write(std::string const& page, std::string const& path, Invocation const& invocation) {
  if (path == "-") {
    invocation.streams.out.write(page);
    return;
  }
  OutputFile file(path);
  file.write(page);
  file.commit();
}

}  // namespace

ExitStatus report(Invocation const& invocation) {
  ReportOptions options;
  CommandLine command_line("report", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.require(options.output.has_value(), "-o FILE.html");
  std::vector<std::string> named{*options.input};
  if (options.before) named.push_back(*options.before);
  refuse_overwriting({*options.output}, named);

  SettingsFinder settings;
  CheckJob job;
  job.options.cycle_time = asked_cycle_time(options.cycle_time);
  job.settings = &settings;
  ReportSubject subject{.input = *options.input,
                        .findings = {},
                        .counts = {},
                        .plots = {},
                        .contour = read_contour_words(options.contour),
                        .language = invocation.language};
  if (!options.contour.feeds) subject.contour.feeds = {1000, 2000, 4000};
  auto const path = machine_input(*options.input);
  auto inputs =
      expand_inputs({*options.input}, [&](std::string const& file) { return settings.wants(file); });
  if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
  invocation.streams.err.write(note_lines(inputs.notes, invocation.language));
  if (std::find(inputs.paths.begin(), inputs.paths.end(), path) == inputs.paths.end()) inputs.paths = {path};
  job.found = std::move(inputs.found);
  auto const machine = checked(subject, path, inputs.paths, job);
  std::optional<ImageFile> image;
  std::optional<image::RuntimeHost> host;
  Earlier old;
  std::optional<ShownDifference> difference;
  if (machine) {
    refuse_overwriting({*options.output}, machine->files);
    image.emplace(image_of(machine->machine, *options.input));
    host.emplace(start_runtime(*options.input, *image));
    subject.machine = &machine->machine;
    subject.plots.emplace(PlotSubject{.now = {.file = *image, .host = *host},
                                      .before = std::nullopt,
                                      .axes = chosen_axes(image->contents, std::nullopt),
                                      .language = invocation.language});
  }
  if (options.before) {
    bool const color = use_color(command_line.color(), system::Stream::error);
    old.read(options, job, invocation, color);
    if (!old.difference) return ExitStatus::findings;
    difference.emplace(
        ShownDifference{.before = *options.before, .after = *options.input, .difference = *old.difference});
    subject.difference = &*difference;
    if (subject.plots && old.host) {
      subject.plots->before.emplace(
          PlottedImage{.file = *old.before->image, .host = *old.host, .steps = &*old.steps});
    }
  }
  write(report_page(subject), *options.output, invocation);
  return subject.counts.errors > 0 ? ExitStatus::findings : ExitStatus::success;
}

}  // namespace axisc::cli
