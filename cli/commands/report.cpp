#include "axisc/answers/difference/machine_difference.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/checking/report_format.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "axisc/workspace/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/named_files.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/printed_errors.hpp"

#include <algorithm>
#include <memory>

namespace axisc::cli::says {

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
  bool alone = false;
  ContourWords contour;
};

void declare(CommandLine& command_line, ReportOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_reported);
  command_line.value("-o,--output", "FILE.html", options.output, says::option_page);
  command_line.value("--before", "OTHER", options.before, says::option_earlier);
  declare_feeds(command_line, options.contour);
  declare_angle(command_line, options.contour);
  declare_radius(command_line, options.contour);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
}

/// The machine at `path`, and whatever else lies in a folder, in the order of `lint`; every finding is kept.
/// None after errors.
std::optional<CheckedMachine> checked(ReportSubject& subject, std::string const& path,
                                      std::vector<std::string> const& inputs, Workspace& workspace) {
  std::optional<CheckedMachine> machine;
  std::optional<Failure> refused;
  for (auto const& input : inputs) {
    SourceSet sources;
    CheckedInput found;
    auto judged = judge_input(workspace, input, found, [&](Finding&& finding, SourceSet const&) {
      found.findings.push_back(std::move(finding));
    });
    if (found.failure) throw Failure(*found.failure);
    for (auto const& finding : found.findings) add_finding(subject, finding, found.sources);
    if (input != path) continue;
    auto& result = judged.result;
    refused = refusal(path, result, found.sources, subject.language);
    if (!result.machine) continue;
    if (!refused) require_cycle_time(path, result);
    machine.emplace(CheckedMachine{.machine = *std::move(result.machine), .files = std::move(result.files)});
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
  void read(ReportOptions const& options, Workspace& workspace, Invocation const& invocation, bool color) {
    before = compared_machine(workspace, *options.before, printed_errors(invocation, color));
    after = compared_machine(workspace, *options.input, printed_errors(invocation, color));
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
  CommandLine command_line("report", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.require(options.output.has_value(), "-o FILE.html");
  std::vector<std::string> named{*options.input};
  if (options.before) named.push_back(*options.before);
  refuse_overwriting({*options.output}, named);

  Workspace workspace(overrides_with(options.cycle_time));
  ReportSubject subject{.input = *options.input,
                        .findings = {},
                        .counts = {},
                        .plots = {},
                        .contour = read_contour_words(options.contour),
                        .language = invocation.language};
  if (!options.contour.feeds) subject.contour.feeds = {1000, 2000, 4000};
  auto const path = machine_of_input(workspace, {.input = *options.input, .alone = options.alone}).machine;
  auto inputs = expand_inputs({*options.input},
                              [&](std::string const& file) { return workspace.settings().wants(file); });
  if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
  invocation.streams.err.write(note_lines(inputs.notes, invocation.language));
  bool const is_listed = std::find(inputs.paths.begin(), inputs.paths.end(), path) != inputs.paths.end();
  if (!is_listed) {
    inputs.paths = {path};
    // Of a list it is the page of its machine.
    if (path != machine_input(*options.input)) subject.input = path;
  }
  workspace.take(inputs);
  auto const machine = checked(subject, path, inputs.paths, workspace);
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
    old.read(options, workspace, invocation, color);
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
