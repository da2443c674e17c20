#include "axisc/answers/execution/recorded_switches.hpp"
#include "axisc/answers/execution/timed_commands.hpp"
#include "axisc/answers/figures/compare_figure.hpp"
#include "axisc/answers/figures/path_figure.hpp"
#include "axisc/answers/figures/plant_figure.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/figures/plotted_groups.hpp"
#include "axisc/asked/frequencies.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/compiled_input.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/printed_errors.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <filesystem>

namespace axisc::cli::says {

constexpr Sentence argument_plotted{
    "a list, a machine file, a start-up list, a project, a folder with one machine, or an image",
    "eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt, ein Ordner mit einer Maschine oder "
    "ein Abbild"};
constexpr Sentence option_kind{"what to draw (default: response)",
                               "was zu zeichnen ist (Standardwert: response)"};
constexpr Sentence option_picture{
    "where the picture goes: FILE.svg, FILE.html, or - for standard output (default: the terminal)",
    "wohin das Bild geht: DATEI.svg, DATEI.html oder - für die Standardausgabe (Standardwert: das Terminal)"};
constexpr Sentence option_picture_format{"format of the picture, whatever the name's ending",
                                         "Format des Bilds, wie die Datei auch endet"};
constexpr Sentence option_before{
    "an earlier state of the same machine: drawn dashed, with a table of the differences",
    "ein früherer Stand derselben Maschine: gestrichelt, mit Tabelle der Unterschiede"};
constexpr Sentence option_table{"print the numbers of the picture as a table",
                                "die Zahlen des Bilds als Tabelle ausgeben"};
constexpr Sentence option_plotted_axis{"only this axis, with each of its filters (default: all)",
                                       "nur diese Achse, mit jedem ihrer Filter (Standardwert: alle)"};
constexpr Sentence option_mark{"also mark this frequency: 48 or 48Hz",
                               "auch diese Frequenz markieren: 48 oder 48Hz"};
constexpr Sentence option_linear{"linear frequency (default: logarithmic)",
                                 "lineare Frequenz (Standardwert: logarithmisch)"};
constexpr Sentence option_magnitude{"magnitude in dB or as a factor (default: db)",
                                    "Betrag in dB oder als Faktor (Standardwert: db)"};
constexpr Sentence option_wrap{"phase from -180° to 180° (default: continuous)",
                               "Phase von -180° bis 180° (Standardwert: stetig)"};
constexpr Sentence option_measured{
    "also draw a measured response, and what the axis' chain makes of it: frequency_hz, magnitude_db[, "
    "phase_deg]",
    "auch einen gemessenen Frequenzgang zeichnen und was die Kette der Achse daraus macht: frequency_hz, "
    "magnitude_db[, phase_deg]"};
constexpr Sentence option_plotted_plant{"drive and mechanics for --kind plant",
                                        "Antrieb und Mechanik für --kind plant"};
constexpr Sentence option_plotted_move{"there and back with the plant (default: vb_max)",
                                       "hin und zurück mit der Strecke (Standardwert: vb_max)"};
constexpr Sentence option_plotted_program{"NC program for --kind path", "NC-Programm für --kind path"};
constexpr Sentence option_plane{"axes of the plane, XY or X,Y (default: the group's first two)",
                                "Achsen der Ebene, XY oder X,Y (Standardwert: die ersten beiden der Gruppe)"};
constexpr Sentence option_marked_tolerance{"mark blocks that deviate by more than this, in mm",
                                           "Sätze markieren, die um mehr als das abweichen, in mm"};
constexpr Sentence path_needs{"--kind path needs --program", "--kind path braucht --program"};
constexpr Sentence bad_plane{"--plane needs two axes of the group, {axes}, not \"{value}\"",
                             "--plane braucht zwei Achsen der Gruppe, {axes}, nicht \"{value}\""};
constexpr Sentence option_plotted_recording{"what a scope recorded, for --kind compare",
                                            "was ein Scope aufzeichnete, für --kind compare"};
constexpr Sentence compare_needs{"--kind compare needs --recording", "--kind compare braucht --recording"};
constexpr Sentence plant_needs{"--kind plant needs --plant and --move",
                               "--kind plant braucht --plant und --move"};
constexpr Sentence kind_of_image{"--kind {kind} needs the machine: {file} is an image",
                                 "--kind {kind} braucht die Maschine: {file} ist ein Abbild"};
constexpr Sentence order_of_image{
    "--order needs the machine: {file} is an image, compiled for its own orders only",
    "--order braucht die Maschine: {file} ist ein Abbild, nur für seine eigenen "
    "Ordnungen kompiliert"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Kind : std::uint8_t { response, step, delay, corner, circle, plant, path, compare };

std::initializer_list<std::pair<std::string_view, Kind>> const kinds = {
    {"response", Kind::response}, {"step", Kind::step}, {"delay", Kind::delay}, {"corner", Kind::corner},
    {"circle", Kind::circle},     {"path", Kind::path}, {"plant", Kind::plant}, {"compare", Kind::compare}};

std::string_view word_of(Kind kind) {
  return std::find_if(kinds.begin(), kinds.end(), [kind](auto const& row) { return row.second == kind; })
      ->first;
}

struct PlotOptions {
  std::optional<std::string> input, before, axis, group, cycle_time, measured, plant, move, program, plane,
      tolerance, recording;
  WantedColumns columns;
  RecordedUnit unit = RecordedUnit::recognised;
  PictureTarget target;
  std::vector<std::string> marks, commands;
  bool alone = false;
  Kind kind = Kind::response;
  ResponsePlot response;
  ContourWords contour;
};

void declare(CommandLine& command_line, PlotOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_plotted);
  command_line.value("-o,--output", "FILE", options.target.path, says::option_picture);
  command_line.choice("--kind", kinds, options.kind, says::option_kind);
  command_line.flag("--table", options.target.table, says::option_table);
  command_line.choice("--format", {{"svg", PictureFormat::svg}, {"html", PictureFormat::html}},
                      options.target.format, says::option_picture_format);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
  command_line.only_for("response, step, delay, corner, circle");
  command_line.value("--before", "OTHER", options.before, says::option_before);
  command_line.only_for("response, step, delay, compare");
  command_line.value("--axis", "NAME", options.axis, says::option_plotted_axis);
  command_line.values("--at", "CYCLE:COMMAND", options.commands, says::option_at);
  command_line.only_for("response");
  command_line.values("--mark", "HZ", options.marks, says::option_mark);
  command_line.flag("--linear", options.response.linear_frequency, says::option_linear);
  command_line.choice("--magnitude", {{"db", false}, {"linear", true}}, options.response.linear_magnitude,
                      says::option_magnitude);
  command_line.flag("--wrap", options.response.wraps_phase, says::option_wrap);
  command_line.value("--measured", "FILE.csv", options.measured, says::option_measured);
  command_line.only_for("corner, circle, path");
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.only_for("corner, circle");
  declare_feeds(command_line, options.contour);
  declare_orders(command_line, options.contour);
  command_line.only_for("corner");
  declare_angle(command_line, options.contour);
  command_line.only_for("circle");
  declare_radius(command_line, options.contour);
  command_line.only_for("path");
  command_line.value("--program", "PART.nc", options.program, says::option_plotted_program);
  command_line.value("--plane", "XY", options.plane, says::option_plane);
  command_line.value("--tolerance", "MM", options.tolerance, says::option_marked_tolerance);
  command_line.only_for("plant");
  command_line.value("--plant", "PLANT.json", options.plant, says::option_plotted_plant);
  command_line.value("--move", "AXIS:MM[:MM_PER_MIN]", options.move, says::option_plotted_move);
  command_line.only_for("compare");
  command_line.value("--recording", "RECORDING.csv", options.recording, says::option_plotted_recording);
  command_line.value("--in", "COLUMN", options.columns.input, says::option_setpoint_column);
  command_line.value("--out", "COLUMN", options.columns.output, says::option_filtered_column);
  command_line.choice("--unit",
                      {{"0.1um", RecordedUnit::tenths},
                       {"um", RecordedUnit::um},
                       {"mm", RecordedUnit::mm},
                       {"incr", RecordedUnit::increments}},
                      options.unit, says::option_recorded_unit);
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

bool is_contour(Kind kind) {
  return kind == Kind::corner || kind == Kind::circle;
}

void require_parts(PlotOptions const& options) {
  if (options.kind == Kind::path && !options.program) {
    throw Failure({.sentence = says::path_needs, .arguments = {}});
  }
  if (options.kind == Kind::compare && !options.recording) {
    throw Failure({.sentence = says::compare_needs, .arguments = {}});
  }
  if (options.kind == Kind::plant && (!options.plant || !options.move)) {
    throw Failure({.sentence = says::plant_needs, .arguments = {}});
  }
}

/// An input with its runtime.
struct Plotted {
  InputImage input;
  image::RuntimeHost host;
};

std::optional<Plotted> plotted(PlotOptions const& options, std::string const& path,
                               Invocation const& invocation, bool color) {
  auto input = compiled_input(
      {.input = path, .cycle_time = asked_cycle_time(options.cycle_time), .alone = options.alone},
      printed_errors(invocation, color));
  if (!input) return std::nullopt;
  auto host = start_runtime(path, input->image);
  bool const at_once = options.kind != Kind::compare;
  for (auto const& command : read_timed_commands(options.commands, input->image, path, invocation.language)) {
    if (at_once) execute(command, host, input->image.contents, path);
  }
  return Plotted{.input = std::move(*input), .host = std::move(host)};
}

pictures::Figure contour_figure(PlotOptions const& options, InputImage const& now, InputImage const* before,
                                Language language) {
  auto const wanted = read_contour_words(options.contour);
  if (options.contour.orders) {
    for (auto const& [input, path] : {std::pair(&now, &options.input), {before, &options.before}}) {
      if (input == nullptr || input->machine) continue;
      throw Failure({.sentence = says::order_of_image, .arguments = {{"file", **path}}});
    }
  }
  auto chains = group_chains(now, options.group ? options.group : now.group(), wanted, *options.input);
  auto earlier = before != nullptr
                     ? std::optional(group_chains(*before, options.group ? options.group : before->group(),
                                                  wanted, *options.before))
                     : std::nullopt;
  ContourSubject const subject{.now = chains,
                               .before = earlier ? &*earlier : nullptr,
                               .cycle_time = now.image.contents.cycle_time,
                               .axes = axis_names(now.image.contents, chains.group()),
                               .language = language};
  return options.kind == Kind::corner ? corner_figure(subject, wanted) : circle_figure(subject, wanted);
}

CheckedMachine const& machine_of(PlotOptions const& options, InputImage const& input, std::string kind) {
  if (input.machine) return *input.machine;
  throw Failure(
      {.sentence = says::kind_of_image, .arguments = {{"kind", std::move(kind)}, {"file", *options.input}}});
}

/// "XY" or "X,Y"; without one the first two axes, of a single one itself.
std::pair<std::size_t, std::size_t> plane_of(std::optional<std::string> const& word,
                                             std::vector<std::string> const& axes) {
  if (!word) return {0, axes.size() > 1 ? 1 : 0};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      if (i != j && (*word == axes[i] + axes[j] || *word == axes[i] + "," + axes[j])) return {i, j};
    }
  }
  std::string names;
  for (auto const& axis : axes) names += (names.empty() ? "" : ", ") + axis;
  throw Failure({.sentence = says::bad_plane, .arguments = {{"axes", names}, {"value", *word}}});
}

/// None after mistakes in the program, which are printed.
std::optional<pictures::Figure> followed_path(PlotOptions const& options, CheckedMachine const& checked,
                                              Invocation const& invocation, bool color) {
  auto machine = checked.machine;
  auto const group = chosen_group(machine, options.group ? options.group : checked.group, *options.input);
  std::vector<std::string> axes;
  for (auto const axis : machine.groups[group].axes) axes.push_back(machine.axes[axis].name);
  auto const plane = plane_of(options.plane, axes);
  std::optional<double> tolerance;
  constexpr double um_per_mm = 1000;
  if (options.tolerance) tolerance = positive_number("--tolerance", *options.tolerance) * um_per_mm;
  ProgramRequest const request{.machine_path = *options.input, .program_path = *options.program};
  ProgramLines program(request.program_path);
  auto const problems = printed_problems(invocation, color);
  if (!survey_program(program, request, machine, group, problems)) return std::nullopt;
  PathRecorder recorder(plane.first, plane.second);
  static_cast<void>(follow_program(program, request, machine, group, recorder));
  return path_figure(recorder,
                     {.program = system::name_of(system::path_of(*options.program).filename()),
                      .axes = {axes[plane.first], axes[plane.second]},
                      .cycle_seconds = machine.cycle_time.seconds(),
                      .tolerance_um = tolerance},
                     invocation.language);
}

}  // namespace

ExitStatus plot(Invocation const& invocation) {
  PlotOptions options;
  CommandLine command_line("plot", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.refuse_others(word_of(options.kind));
  require_parts(options);
  options.target.check();
  std::vector<std::string> inputs{*options.input};
  for (auto const& other :
       {options.before, options.measured, options.plant, options.program, options.recording}) {
    if (other) inputs.push_back(*other);
  }
  if (options.target.path) refuse_overwriting({*options.target.path}, inputs);

  bool const color = use_color(command_line.color(), system::Stream::error);
  auto now = plotted(options, *options.input, invocation, color);
  if (!now) return ExitStatus::findings;
  auto before = options.before ? plotted(options, *options.before, invocation, color) : std::nullopt;
  if (options.before && !before) return ExitStatus::findings;

  auto const& contents = now->input.image.contents;
  auto const& named_axis = options.axis ? options.axis : now->input.axis();
  pictures::Figure figure;
  if (options.kind == Kind::plant) {
    auto const& machine = machine_of(options, now->input, "plant");
    auto const run =
        run_plant({.machine_path = *options.input, .plant_path = *options.plant, .move = *options.move},
                  machine, false);
    figure = plant_figure(run, invocation.language);
  } else if (options.kind == Kind::path) {
    auto found = followed_path(options, machine_of(options, now->input, "path"), invocation, color);
    if (!found) return ExitStatus::findings;
    figure = *std::move(found);
  } else if (options.kind == Kind::compare) {
    auto const axis = recorded_axis(contents, named_axis, *options.input);
    auto const commands =
        read_timed_commands(options.commands, now->input.image, *options.input, invocation.language);
    auto const found = compare_axis(contents, axis, *options.recording, options.columns, options.unit,
                                    kernel_switches(commands, contents, axis, *options.input));
    figure =
        compare_figure(found, axis_label(contents, axis), contents.cycle_time.seconds(), invocation.language);
  } else if (is_contour(options.kind)) {
    figure = contour_figure(options, now->input, before ? &before->input : nullptr, invocation.language);
  } else {
    if (options.measured) options.response.measured = read_measured_response(*options.measured);
    options.response.marks = frequencies_of(options.marks, contents.cycle_time);
    PlotSubject const subject{
        .now = {.file = now->input.image, .host = now->host},
        .before = before ? std::optional(PlottedImage{.file = before->input.image, .host = before->host})
                         : std::nullopt,
        .axes = chosen_axes(contents, named_axis),
        .is_switched = !options.commands.empty(),
        .language = invocation.language};
    figure = options.kind == Kind::response ? response_figure(subject, options.response)
             : options.kind == Kind::step   ? step_figure(subject)
                                            : delay_figure(subject);
  }
  figure.shows_table = before.has_value();
  write_picture(figure, options.target, invocation);
  return ExitStatus::success;
}

}  // namespace axisc::cli
