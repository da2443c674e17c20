#include "axisc/answers/report/report_answer.hpp"

#include "axisc/answers/contour/delay_budget_answer.hpp"
#include "axisc/answers/difference/machine_difference.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/workspace/inputs.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace axisc {

namespace {

/// The machine at `path`, and whatever else lies in a folder, in the order of `lint`; every finding is kept.
/// None after errors. What is read is added to `files`.
std::optional<machine::Machine> checked(ReportSubject& subject, std::string const& path,
                                        std::vector<std::string> const& inputs, Workspace& workspace,
                                        std::vector<std::string>& files) {
  std::optional<machine::Machine> machine;
  std::optional<Failure> refused;
  for (auto const& input : inputs) {
    SourceSet sources;
    CheckedInput found;
    auto judged = judge_input(workspace, input, found, [&](Finding&& finding, SourceSet const&) {
      found.findings.push_back(std::move(finding));
    });
    if (found.failure) throw Failure(*found.failure);
    for (auto const& finding : found.findings) add_finding(subject, finding, found.sources);
    subject.files += found.files.size();
    auto& result = judged.result;
    files.insert(files.end(), result.files.begin(), result.files.end());
    add_settings_files(workspace.settings(), input, files);
    if (input != path) continue;
    refused = refusal(path, result, found.sources, subject.language);
    if (!result.machine) continue;
    if (!refused) require_cycle_time(path, result);
    machine = std::move(result.machine);
  }
  if (subject.counts.errors > 0) return std::nullopt;
  // Without a machine the page could not say that it is ready.
  if (refused) throw Failure(*refused);
  return machine;
}

/// What the machine file says about the cover, where the question says nothing.
void fill_cover(ReportSubject& subject, ReportQuestion const& question,
                validator::LoadedMachine const& loaded) {
  subject.cover = question.cover;
  auto const fill = [](std::string& text, std::optional<configuration::LocatedText> const& said) {
    if (text.empty() && said) text = said->text;
  };
  auto const& said = loaded.report;
  fill(subject.cover.title, said.title);
  fill(subject.cover.customer, said.customer);
  fill(subject.cover.author, said.author);
  fill(subject.cover.date, said.date);
  if (!subject.contour.tolerance_mm) subject.contour.tolerance_mm = said.tolerance_mm;
  if (!subject.cover.title.empty()) return;
  // A start-up list tells no name of the machine, its folder often does.
  std::string folder = question.input;
  while (folder.ends_with('/') || folder.ends_with('\\')) folder.pop_back();
  folder = validator::file_name(folder);
  bool const is_name =
      loaded.start_up && !folder.empty() && folder.find_first_not_of('.') != std::string::npos;
  subject.cover.title = is_name ? folder : loaded.name;
}

std::vector<ReportedContour> contours_of(ReportSubject const& subject) {
  std::vector<ReportedContour> contours;
  auto wanted = subject.contour;
  wanted.tries_orders = false;
  for (std::size_t i = 0; i < subject.machine->groups.size(); ++i) {
    auto& contour = contours.emplace_back();
    if (subject.machine->groups[i].axes.empty()) continue;
    try {
      contour.figures = predict_contour(
          {.machine = *subject.machine, .group = i, .commands = filters_on(), .path = subject.input}, wanted);
    } catch (Failure const& failure) {
      // A chain without a constant part, or more axes than a path has.
      contour.reason = failure.sentence(subject.language);
    }
  }
  return contours;
}

/// An earlier state beside the present one.
struct Earlier {
  std::shared_ptr<ComparedMachine> before;
  std::optional<MachineDifference> difference = std::nullopt;
  std::optional<image::RuntimeHost> host = std::nullopt;
  std::optional<image::StepAnswers> steps = std::nullopt;

  /// Of lists their machines, as the page shows them.
  void read(Workspace& workspace, ReportQuestion const& question, ErrorSink const& errors) {
    auto const machine_of = [&](std::string const& input) {
      return machine_of_input(workspace, {.input = input, .alone = question.alone}).machine;
    };
    sides_ = compared_sides(workspace, machine_of(*question.before), machine_of(question.input), errors);
    if (!sides_) return;
    before = sides_->before;
    difference.emplace(compare_machines(*sides_->before, *sides_->after, false));
    if (!before->image) return;
    host.emplace(start_runtime(*question.before, *before->image));
    steps.emplace(before->image->bytes.bytes(), before->image->contents);
  }

  [[nodiscard]] std::optional<std::string> read_by_both() const { return sides_->read_by_both; }

 private:
  std::optional<ComparedSides> sides_;
};

}  // namespace

std::optional<ReportAnswer> report_answer(Workspace& workspace, ReportQuestion const& question,
                                          ErrorSink const& errors, std::vector<Message>& notes) {
  auto const& input = question.input;
  ReportSubject subject{.input = input,
                        .cover = {},
                        .findings = {},
                        .counts = {},
                        .plots = {},
                        .contour = question.contour,
                        .language = question.language};
  auto const path = machine_of_input(workspace, {.input = input, .alone = question.alone}).machine;
  auto inputs =
      expand_inputs({input}, [&](std::string const& file) { return workspace.settings().wants(file); });
  if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
  notes = std::move(inputs.notes);
  bool const is_listed = std::find(inputs.paths.begin(), inputs.paths.end(), path) != inputs.paths.end();
  if (!is_listed) inputs.paths = {path};
  workspace.take(inputs);
  std::vector<std::string> files;
  auto const machine = checked(subject, path, inputs.paths, workspace, files);
  SourceSet sources;
  auto const loaded = loaded_machine(workspace, path, sources);
  fill_cover(subject, question, loaded);
  std::optional<ImageFile> image;
  std::optional<image::RuntimeHost> host;
  Earlier old;
  std::optional<ShownDifference> difference;
  if (machine) {
    image.emplace(image_of(*machine, input));
    host.emplace(start_runtime(input, *image));
    subject.machine = &*machine;
    subject.contours = contours_of(subject);
    subject.delays = {delay_budget_section(loaded, sources, std::nullopt)};
    subject.plots.emplace(PlotSubject{.now = {.file = *image, .host = *host, .machine = subject.machine},
                                      .before = std::nullopt,
                                      .axes = chosen_axes(image->contents, std::nullopt),
                                      .language = question.language});
  }
  if (question.before) {
    old.read(workspace, question, errors);
    if (!old.difference) return std::nullopt;
    if (auto const& loaded_before = old.before->loaded) {
      files.insert(files.end(), loaded_before->files.begin(), loaded_before->files.end());
      add_settings_files(workspace.settings(), loaded_before->path, files);
    }
    difference.emplace(ShownDifference{.before = *question.before,
                                       .after = input,
                                       .difference = *old.difference,
                                       .read_by_both = old.read_by_both()});
    subject.difference = &*difference;
    if (subject.plots && old.host) {
      subject.plots->before.emplace(
          PlottedImage{.file = *old.before->image,
                       .host = *old.host,
                       .steps = &*old.steps,
                       .machine = old.before->machine ? &*old.before->machine : nullptr});
    }
  }
  return ReportAnswer{.page = report_page(subject), .counts = subject.counts, .files = std::move(files)};
}

}  // namespace axisc
