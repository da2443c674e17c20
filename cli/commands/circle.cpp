#include "axisc/answers/circle/circle_answer.hpp"
#include "axisc/answers/circle/circular_figure.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/checking_options.hpp"
#include "axisc/files/protected_files.hpp"
#include "axisc/files/recorded_positions.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/recorded_numbers.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/decimal_comma.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_circle{
    "the machine, then recordings of its circle: one of both directions, or one of each",
    "die Maschine, dann Aufzeichnungen ihres Kreises: eine beider Richtungen oder je eine"};
constexpr Sentence option_circle_feed{"feed rates in mm/min; without a recording required",
                                      "Vorschübe in mm/min; ohne Aufzeichnung nötig"};
constexpr Sentence option_circle_radius{"radius in mm; required without setpoints in a recording",
                                        "Radius in mm; nötig ohne Sollwerte in einer Aufzeichnung"};
constexpr Sentence option_circle_plane{
    "axes of the plane, XY or X,Y (default: every pair of linear axes)",
    "Achsen der Ebene, XY oder X,Y (Standardwert: jedes Paar von Linearachsen)"};
constexpr Sentence option_circle_recording{"a recording of the circle; may be repeated",
                                           "eine Aufzeichnung des Kreises; mehrfach möglich"};
constexpr Sentence option_circle_setpoint{"column of the setpoint of an axis",
                                          "Spalte des Sollwerts einer Achse"};
constexpr Sentence option_circle_actual{"column of the actual position of an axis",
                                        "Spalte der Istposition einer Achse"};
constexpr Sentence option_external{
    "the recordings are of a measuring instrument: columns angle_deg, deviation_um",
    "die Aufzeichnungen sind von einem Messgerät: Spalten angle_deg, deviation_um"};
constexpr Sentence option_circle_tolerance{"allowed circular deviation in µm: exit status 1 beyond it",
                                           "erlaubte Kreisformabweichung in µm: darüber Rückgabewert 1"};
constexpr Sentence option_circle_picture{
    "also draw the circle: FILE.svg, FILE.html; - draws an SVG instead of the text",
    "den Kreis auch zeichnen: DATEI.svg, DATEI.html; - zeichnet ein SVG statt des Texts"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct CircleOptions {
  CircleQuestion question;
  std::vector<std::string> inputs, recordings, setpoints, actuals;
  std::optional<std::string> feeds, radius, tolerance, cycle_time;
  RecordedNumbers numbers;
  PictureTarget picture;
  presentation::Format format = presentation::Format::text;
};

void declare(CommandLine& command_line, CircleOptions& options) {
  auto& question = options.question;
  command_line.arguments("MACHINE [RECORDING...]", options.inputs, says::argument_circle);
  command_line.value("--feed", "F[,F...]", options.feeds, says::option_circle_feed);
  command_line.value("--radius", "MM", options.radius, says::option_circle_radius);
  command_line.value("--plane", "XY", question.plane, says::option_circle_plane);
  command_line.value("--tolerance", "UM", options.tolerance, says::option_circle_tolerance);
  command_line.values("--recording", "FILE", options.recordings, says::option_circle_recording);
  command_line.flag("--external", question.recorded.is_external, says::option_external);
  command_line.values("--setpoint", "AXIS=COLUMN", options.setpoints, says::option_circle_setpoint);
  command_line.values("--actual", "AXIS=COLUMN", options.actuals, says::option_circle_actual);
  declare_recorded_numbers(command_line, options.numbers);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, question.machine.alone);
  command_line.value("-o,--output", "FILE", options.picture.path, says::option_circle_picture);
  declare_format(command_line, options.format);
}

void read(CircleOptions& options) {
  auto& question = options.question;
  question.machine.input = options.inputs.front();
  question.recordings = options.recordings;
  question.recordings.insert(question.recordings.end(), options.inputs.begin() + 1, options.inputs.end());
  for (auto const& word : split_list(options.feeds.value_or(""))) {
    question.feeds.push_back(positive_number("--feed", word, "mm/min"));
  }
  if (options.radius) question.radius_mm = positive_number("--radius", *options.radius, "mm");
  if (options.tolerance) {
    question.tolerance_um = positive_number("--tolerance", *options.tolerance, "µm");
  }
  question.recorded.setpoints = axis_columns("--setpoint", options.setpoints);
  question.recorded.actuals = axis_columns("--actual", options.actuals);
  question.recorded.units = options.numbers.units();
}

}  // namespace

ExitStatus circle(Invocation const& invocation) {
  CircleOptions options;
  CommandLine command_line("circle", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!options.inputs.empty(), "MACHINE");
  options.picture.check();
  read(options);
  remark_decimal_comma(invocation, "--feed", options.feeds);
  Workspace workspace(with_unlike_delays(overrides_with(options.cycle_time)));
  auto const test =
      circular_test(workspace, options.question,
                    printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!test) return ExitStatus::findings;
  auto const& picture = options.picture.path;
  if (picture) refuse_overwriting({*picture}, test->files);
  if (picture != "-") print(circle_answer(*test), options.format, invocation, command_line);
  if (picture) write_picture(circular_figure(*test, invocation.language), options.picture, invocation);
  return test->keeps_tolerance() ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
