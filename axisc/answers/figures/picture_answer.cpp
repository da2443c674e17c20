#include "axisc/answers/figures/picture_answer.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/execution/recorded_input.hpp"
#include "axisc/answers/execution/timed_commands.hpp"
#include "axisc/answers/figures/compare_figure.hpp"
#include "axisc/answers/figures/path_figure.hpp"
#include "axisc/answers/figures/plant_figure.hpp"
#include "axisc/answers/figures/plotted_groups.hpp"
#include "axisc/answers/figures/robustness_figure.hpp"
#include "axisc/answers/simulation/followed_program.hpp"
#include "axisc/asked/frequencies.hpp"
#include "axisc/asked/plane.hpp"
#include "axisc/checking/compiled_input.hpp"
#include "axisc/environment/failure.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <filesystem>

namespace axisc::says {

constexpr Sentence path_needs{"--kind path needs --program", "--kind path braucht --program"};
constexpr Sentence compare_needs{"--kind compare needs --recording", "--kind compare braucht --recording"};
constexpr Sentence plant_needs{"--kind plant needs --plant and --move",
                               "--kind plant braucht --plant und --move"};
constexpr Sentence kind_of_image{"--kind {kind} needs the machine: {file} is an image",
                                 "--kind {kind} braucht die Maschine: {file} ist ein Abbild"};
constexpr Sentence order_of_image{
    "--order needs the machine: {file} is an image, compiled for its own orders only",
    "--order braucht die Maschine: {file} ist ein Abbild, nur für seine eigenen "
    "Ordnungen kompiliert"};

}  // namespace axisc::says

namespace axisc {

namespace {

void require_parts(PictureQuestion const& question) {
  if (question.kind == PictureKind::path && !question.program) {
    throw Failure({says::path_needs});
  }
  if (question.kind == PictureKind::compare && !question.recording) {
    throw Failure({says::compare_needs});
  }
  if (question.kind == PictureKind::plant && (!question.plant || !question.move)) {
    throw Failure({says::plant_needs});
  }
}

/// "48" or "48Hz".
std::vector<double> frequencies_of(std::vector<std::string> const& marks, design::CycleTime cycle_time) {
  std::vector<double> frequencies;
  for (std::string word : marks) {
    if (word.ends_with("Hz")) word.resize(word.size() - 2);
    auto const read = parse_frequencies(word, cycle_time);
    frequencies.insert(frequencies.end(), read.begin(), read.end());
  }
  return frequencies;
}

/// An input with its runtime.
struct Plotted {
  InputImage input;
  image::RuntimeHost host;
};

std::optional<Plotted> plotted(Workspace& workspace, PictureQuestion const& question, std::string const& path,
                               ErrorSink const& errors) {
  auto input = compiled_input(workspace, {.input = path, .alone = question.alone}, errors);
  if (!input) return std::nullopt;
  auto host = start_runtime(path, input->image);
  bool const at_once = question.kind != PictureKind::compare;
  for (auto const& command : read_timed_commands(question.commands, input->image, path, question.language)) {
    if (at_once) execute(command, host, input->image.contents, path);
  }
  return Plotted{.input = std::move(*input), .host = std::move(host)};
}

GroupChains chains_of(PictureQuestion const& question, InputImage const& input, std::string const& path) {
  auto const& orders = question.contour.orders;
  bool const names_order =
      std::any_of(orders.begin(), orders.end(), [](auto order) { return order.has_value(); });
  if (names_order && !input.machine) {
    throw Failure({says::order_of_image, {{"file", path}}});
  }
  return group_chains(input, question.group ? question.group : input.group(), question.contour, path);
}

pictures::Figure contour_figure(PictureQuestion const& question, InputImage const& now,
                                InputImage const* before) {
  auto chains = chains_of(question, now, question.input);
  auto earlier =
      before != nullptr ? std::optional(chains_of(question, *before, *question.before)) : std::nullopt;
  ContourSubject const subject{.now = chains,
                               .before = earlier ? &*earlier : nullptr,
                               .cycle_time = now.image.contents.cycle_time,
                               .axes = axis_names(now.image.contents, chains.group()),
                               .language = question.language};
  return question.kind == PictureKind::corner ? corner_figure(subject, question.contour)
                                              : circle_figure(subject, question.contour);
}

pictures::Figure axes_figure(PictureQuestion const& question, Plotted& now, Plotted* before) {
  auto const& contents = now.input.image.contents;
  auto const image_of = [](Plotted& state) {
    auto const& machine = state.input.machine;
    return PlottedImage{
        .file = state.input.image, .host = state.host, .machine = machine ? &machine->machine : nullptr};
  };
  PlotSubject const subject{.now = image_of(now),
                            .before = before != nullptr ? std::optional(image_of(*before)) : std::nullopt,
                            .axes = chosen_axes(contents, question.axis ? question.axis : now.input.axis()),
                            .is_switched = !question.commands.empty(),
                            .language = question.language};
  if (question.kind == PictureKind::step) return step_figure(subject);
  if (question.kind == PictureKind::delay) return delay_figure(subject);
  if (question.kind == PictureKind::robustness) return robustness_figure(subject);
  auto response = question.response;
  if (question.measured) response.measured = read_measured_response(*question.measured);
  response.marks = frequencies_of(question.marks, contents.cycle_time);
  return response_figure(subject, response);
}

CheckedMachine const& machine_of(PictureQuestion const& question, InputImage const& input,
                                 std::string const& path) {
  if (input.machine) return *input.machine;
  throw Failure({says::kind_of_image, {{"kind", std::string(word_of(question.kind))}, {"file", path}}});
}

pictures::Figure driven_figure(PictureQuestion const& question, Plotted& now, Plotted* before) {
  auto const of_machine = [&](Plotted& state, std::string const& path) {
    return PlottedImage{.file = state.input.image,
                        .host = state.host,
                        .machine = &machine_of(question, state.input, path).machine};
  };
  PlotSubject const subject{
      .now = of_machine(now, question.input),
      .before = before != nullptr ? std::optional(of_machine(*before, *question.before)) : std::nullopt,
      .axes = chosen_axes(now.input.image.contents, question.axis ? question.axis : now.input.axis()),
      .language = question.language};
  return dynamics_figure(subject, question.move_at_feed);
}

pictures::Figure compared(PictureQuestion const& question, InputImage const& input) {
  auto const& contents = input.image.contents;
  auto const [axis, recorded] = recorded_input({.input = question.input,
                                                .recording = *question.recording,
                                                .axis = question.axis,
                                                .commands = question.commands,
                                                .columns = question.columns,
                                                .units = question.units,
                                                .language = question.language},
                                               input);
  return compare_figure(recorded, axis_label(contents, axis), contents.cycle_time.seconds(),
                        question.language);
}

/// None after mistakes in the program, which are printed.
std::optional<pictures::Figure> followed_path(PictureQuestion const& question, CheckedMachine const& checked,
                                              ErrorSink const& errors) {
  auto machine = checked.machine;
  auto const group = chosen_group(machine, question.group ? question.group : checked.group, question.input);
  std::vector<std::string> axes;
  for (auto const axis : machine.groups[group].axes) axes.push_back(machine.axes[axis].name);
  auto const plane = question.plane ? asked_plane(*question.plane, axes)
                                    : std::pair<std::size_t, std::size_t>(0, axes.size() > 1 ? 1 : 0);
  ProgramRequest const request{.machine_path = question.input, .program_path = *question.program};
  ProgramLines program(request.program_path);
  TakeProblem const take = [&errors](Finding const& problem, SourceSet const& sources) {
    errors.take({problem}, sources);
  };
  if (!survey_program(program, request, machine, group, take)) return std::nullopt;
  PathRecorder recorder(plane.first, plane.second);
  static_cast<void>(follow_program(program, request, machine, group, recorder));
  return path_figure(
      recorder,
      {.program = system::name_of(system::path_of(*question.program).filename()),
       .axes = {axes[plane.first], axes[plane.second]},
       .cycle_seconds = machine.cycle_time.seconds(),
       .tolerance_um =
           question.tolerance_mm ? std::optional(*question.tolerance_mm * motion::um_per_mm) : std::nullopt},
      question.language);
}

}  // namespace

std::string_view word_of(PictureKind kind) {
  return std::find_if(picture_kinds.begin(), picture_kinds.end(),
                      [kind](auto const& row) { return row.second == kind; })
      ->first;
}

std::optional<Picture> picture_answer(Workspace& workspace, PictureQuestion question,
                                      ErrorSink const& errors) {
  require_parts(question);
  auto now = plotted(workspace, question, question.input, errors);
  if (!now) return std::nullopt;
  auto before = question.before ? plotted(workspace, question, *question.before, errors) : std::nullopt;
  if (question.before && !before) return std::nullopt;
  std::optional<pictures::Figure> figure;
  switch (question.kind) {
    case PictureKind::plant:
      figure = plant_figure(
          run_plant({.machine_path = question.input, .plant_path = *question.plant, .move = *question.move},
                    machine_of(question, now->input, question.input), false),
          question.language);
      break;
    case PictureKind::path:
      figure = followed_path(question, machine_of(question, now->input, question.input), errors);
      break;
    case PictureKind::compare: figure = compared(question, now->input); break;
    case PictureKind::corner:
    case PictureKind::circle:
      figure = contour_figure(question, now->input, before ? &before->input : nullptr);
      break;
    case PictureKind::dynamics: figure = driven_figure(question, *now, before ? &*before : nullptr); break;
    case PictureKind::response:
    case PictureKind::step:
    case PictureKind::robustness:
    case PictureKind::delay: figure = axes_figure(question, *now, before ? &*before : nullptr); break;
  }
  if (!figure) return std::nullopt;
  figure->shows_table = before.has_value();
  Picture picture{.figure = *std::move(figure), .files = {}};
  for (auto const* const state : {&*now, before ? &*before : nullptr}) {
    if (state == nullptr || !state->input.machine) continue;
    auto const& files = state->input.machine->files;
    picture.files.insert(picture.files.end(), files.begin(), files.end());
  }
  return picture;
}

}  // namespace axisc
