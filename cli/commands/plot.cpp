#include "axisc/answers/figures/picture_answer.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/recorded_numbers.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/printed_errors.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence option_kind{"what to draw (default: response)",
                               "was zu zeichnen ist (Standardwert: response)"};
constexpr Sentence option_picture_or_terminal{
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
constexpr Sentence option_plotted_feed{
    "feed rates in mm/min (default: 1000; for dynamics one feed rate, 6000)",
    "Vorschübe in mm/min (Standardwert: 1000; für dynamics ein Vorschub, 6000)"};
constexpr Sentence option_distance{"from rest to rest over this distance in mm (default: 100)",
                                   "von Stillstand zu Stillstand über diesen Weg in mm (Standardwert: 100)"};
constexpr Sentence option_mark{"also mark this frequency: 48 or 48Hz",
                               "auch diese Frequenz markieren: 48 oder 48Hz"};
constexpr Sentence option_linear{"linear frequency (default: logarithmic)",
                                 "lineare Frequenz (Standardwert: logarithmisch)"};
constexpr Sentence option_magnitude{"magnitude in dB or as a factor (default: db)",
                                    "Betrag in dB oder als Faktor (Standardwert: db)"};
constexpr Sentence option_wrap{"phase from -180° to 180° (default: continuous)",
                               "Phase von -180° bis 180° (Standardwert: stetig)"};
constexpr Sentence option_measured_response{
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
constexpr Sentence option_plotted_recording{"what a scope recorded, for --kind compare",
                                            "was ein Scope aufzeichnete, für --kind compare"};
}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct PlotOptions {
  PictureQuestion question;
  std::optional<std::string> input, cycle_time, tolerance, distance;
  ContourWords contour;
  RecordedNumbers numbers;
  PictureTarget target;
};

void declare(CommandLine& command_line, PlotOptions& options) {
  auto& question = options.question;
  command_line.argument("INPUT", options.input, says::argument_machine_or_image);
  command_line.value("-o,--output", "FILE", options.target.path, says::option_picture_or_terminal);
  command_line.choice("--kind", picture_kinds, question.kind, says::option_kind);
  command_line.flag("--table", options.target.table, says::option_table);
  command_line.choice("--format", {{"svg", PictureFormat::svg}, {"html", PictureFormat::html}},
                      options.target.format, says::option_picture_format);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, question.alone);
  command_line.only_for("response, step, delay, corner, circle, dynamics, robustness");
  command_line.value("--before", "OTHER", question.before, says::option_before);
  command_line.only_for("response, step, delay, dynamics, robustness, compare");
  command_line.value("--axis", "NAME", question.axis, says::option_plotted_axis);
  command_line.only_for("response, step, delay, compare");
  command_line.values("--at", "CYCLE:COMMAND", question.commands, says::option_at);
  command_line.only_for("response");
  command_line.values("--mark", "HZ", question.marks, says::option_mark);
  command_line.flag("--linear", question.response.linear_frequency, says::option_linear);
  command_line.choice("--magnitude", {{"db", false}, {"linear", true}}, question.response.linear_magnitude,
                      says::option_magnitude);
  command_line.flag("--wrap", question.response.wraps_phase, says::option_wrap);
  command_line.value("--measured", "FILE.csv", question.measured, says::option_measured_response);
  command_line.only_for("corner, circle, path");
  command_line.value("--group", "NAME", question.group, says::option_group);
  command_line.only_for("corner, circle, dynamics");
  command_line.value("--feed", "F[,F...]", options.contour.feeds, says::option_plotted_feed);
  command_line.only_for("corner, circle");
  declare_orders(command_line, options.contour);
  command_line.only_for("corner");
  declare_angle(command_line, options.contour);
  command_line.only_for("circle");
  declare_radius(command_line, options.contour);
  command_line.only_for("dynamics");
  command_line.value("--distance", "MM", options.distance, says::option_distance);
  command_line.only_for("path");
  command_line.value("--program", "PART.nc", question.program, says::option_plotted_program);
  command_line.value("--plane", "XY", question.plane, says::option_plane);
  command_line.value("--tolerance", "MM", options.tolerance, says::option_marked_tolerance);
  command_line.only_for("plant");
  command_line.value("--plant", "PLANT.json", question.plant, says::option_plotted_plant);
  command_line.value("--move", "AXIS:MM[:MM_PER_MIN]", question.move, says::option_plotted_move);
  command_line.only_for("compare");
  command_line.value("--recording", "RECORDING", question.recording, says::option_plotted_recording);
  command_line.value("--in", "COLUMN", question.columns.input, says::option_setpoint_column);
  command_line.value("--out", "COLUMN", question.columns.output, says::option_filtered_column);
  declare_recorded_numbers(command_line, options.numbers);
}

void read_move(PlotOptions& options) {
  auto& move = options.question.move_at_feed;
  if (options.contour.feeds) {
    move.feed_mm_per_min = positive_number("--feed", *options.contour.feeds, "mm/min");
  }
  if (options.distance) move.distance_mm = positive_number("--distance", *options.distance, "mm");
}

}  // namespace

ExitStatus plot(Invocation const& invocation) {
  PlotOptions options;
  auto& question = options.question;
  CommandLine command_line("plot", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.refuse_others(word_of(question.kind));
  options.target.check();
  question.input = *options.input;
  question.language = invocation.language;
  question.contour = read_contour_words(options.contour);
  question.units = options.numbers.units();
  if (question.kind == PictureKind::dynamics) read_move(options);
  if (options.tolerance) question.tolerance_mm = positive_number("--tolerance", *options.tolerance, "mm");
  std::vector<std::string> inputs{question.input};
  for (auto const& other :
       {question.before, question.measured, question.plant, question.program, question.recording}) {
    if (other) inputs.push_back(*other);
  }
  if (options.target.path) refuse_overwriting({*options.target.path}, inputs);
  Workspace workspace(overrides_with(options.cycle_time));
  auto const picture =
      picture_answer(workspace, question,
                     printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!picture) return ExitStatus::findings;
  if (options.target.path) refuse_overwriting({*options.target.path}, picture->files);
  write_picture(picture->figure, options.target, invocation);
  return ExitStatus::success;
}

}  // namespace axisc::cli
