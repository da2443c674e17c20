#include "axisc/answers/suggestion/applied_suggestion.hpp"
#include "axisc/answers/suggestion/suggest_answer.hpp"
#include "axisc/answers/suggestion/suggest_figure.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/decimal_comma.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/printed_errors.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence option_vibrating_axis{"the vibrating axis", "die Achse, die schwingt"};
constexpr Sentence option_resonance{"up to three natural frequencies, each perhaps with its damping ratio",
                                    "bis zu drei Eigenfrequenzen, jede vielleicht mit ihrem Dämpfungsgrad"};
constexpr Sentence argument_suggest{"the machine, then recordings of the axis, as with --measured",
                                    "die Maschine, dann Aufzeichnungen der Achse, wie mit --measured"};
constexpr Sentence option_measured_recordings{
    "find them in recordings instead: two signals over time, a frequency response or a spectrum; may be "
    "repeated",
    "sie stattdessen in Aufzeichnungen finden: zwei Signale über der Zeit, ein Frequenzgang oder ein "
    "Spektrum; mehrfach möglich"};
constexpr Sentence option_in{"column of the measurement's input (torque, or setpoint)",
                             "Spalte des Eingangs der Messung (Drehmoment oder Sollwert)"};
constexpr Sentence option_out{"column of its output (velocity, or position)",
                              "Spalte ihres Ausgangs (Geschwindigkeit oder Position)"};
constexpr Sentence option_plant_of_axis{
    "drive and mechanics of the axis (JSON): compare Improved Position Control too",
    "Antrieb und Mechanik der Achse (JSON): auch die optimierte Lageregelung vergleichen"};
constexpr Sentence option_tolerance{"allowed axis error in mm, on the circle and as AX_DEV (default: 10 µm)",
                                    "erlaubter Achsfehler in mm, auf dem Kreis und als AX_DEV (Standardwert: "
                                    "10 µm)"};
constexpr Sentence option_feed_of_suggestion{"feed rate in mm/min (default: 4000)",
                                             "Vorschub in mm/min (Standardwert: 4000)"};
constexpr Sentence option_radius{
    "circle on which the feed keeps the tolerance, in mm (default: 10)",
    "Kreis, auf dem der Vorschub die Toleranz einhält, in mm (Standardwert: 10)"};
constexpr Sentence option_goal{"what counts more: which suggestion is recommended (default: balanced)",
                               "was mehr zählt: welcher Vorschlag empfohlen wird (Standardwert: ausgewogen)"};
constexpr Sentence option_slope{
    "how the axis accelerates and brakes (default: as the channel list says, without one STEP)",
    "wie die Achse beschleunigt und bremst (Standardwert: nach der Kanalliste, ohne sie STEP)"};
constexpr Sentence option_picture_of_settings{
    "also draw the settings: FILE.svg, FILE.html; - draws an SVG instead of the text",
    "die Einstellungen auch zeichnen: DATEI.svg, DATEI.html; - zeichnet ein SVG statt "
    "des Texts"};
constexpr Sentence option_apply{
    "write suggestion 1, 2, 3, with --plant 4, or the ramp times, 5, into the "
    "lists",
    "Vorschlag 1, 2, 3, mit --plant 4, oder die Rampenzeiten, 5, in die "
    "Listen schreiben"};
constexpr Sentence option_patch_of_lines{"with --apply: show the patch, write nothing",
                                         "mit --apply: den Patch zeigen, nichts schreiben"};
constexpr Sentence diff_is_output{"--diff writes a patch to standard output: leave out {other}",
                                  "--diff schreibt einen Patch auf die Standardausgabe: {other} weglassen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct SuggestOptions {
  SuggestQuestion question;
  std::vector<std::string> inputs;
  std::optional<std::string> tolerance, feed, radius, cycle_time, apply;
  bool diff = false;
  PictureTarget picture;
  presentation::Format format = presentation::Format::text;
};

void declare(CommandLine& command_line, SuggestOptions& options) {
  using Goal = std::optional<tuning::Goal>;
  auto& question = options.question;
  command_line.arguments("MACHINE [RECORDING...]", options.inputs, says::argument_suggest);
  command_line.value("--axis", "NAME", question.axis, says::option_vibrating_axis);
  command_line.value("--resonance", "HZ[:DAMPING][,...]", question.resonances, says::option_resonance);
  command_line.values("--measured", "FILE", question.measured, says::option_measured_recordings);
  command_line.value("--in", "COLUMN", question.columns.in, says::option_in);
  command_line.value("--out", "COLUMN", question.columns.out, says::option_out);
  command_line.value("--plant", "PLANT.json", question.plant, says::option_plant_of_axis);
  command_line.value("--tolerance", "MM", options.tolerance, says::option_tolerance);
  command_line.value("--feed", "MM_PER_MIN", options.feed, says::option_feed_of_suggestion);
  command_line.value("--radius", "MM", options.radius, says::option_radius);
  command_line.choice("--goal",
                      {{"surface", Goal(tuning::Goal::surface)},
                       {"accuracy", Goal(tuning::Goal::accuracy)},
                       {"speed", Goal(tuning::Goal::speed)}},
                      question.goal, says::option_goal);
  using Slope = std::optional<machine::Slope>;
  command_line.choice("--slope",
                      {{"STEP", Slope(machine::Slope::step)},
                       {"TRAPEZ", Slope(machine::Slope::trapez)},
                       {"SIN2", Slope(machine::Slope::sin2)},
                       {"HSC", Slope(machine::Slope::hsc)}},
                      question.slope, says::option_slope);
  command_line.value("-o,--output", "FILE", options.picture.path, says::option_picture_of_settings);
  command_line.value("--apply", "N", options.apply, says::option_apply);
  command_line.only_with("--apply");
  command_line.flag("--diff", options.diff, says::option_patch_of_lines);
  command_line.only_with({});
  declare_format(command_line, options.format);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, question.machine.alone);
}

}  // namespace

ExitStatus suggest(Invocation const& invocation) {
  SuggestOptions options;
  auto& question = options.question;
  CommandLine command_line("suggest", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!options.inputs.empty(), "MACHINE");
  std::optional<std::size_t> number;
  if (options.apply) number = suggestion_number(*options.apply, question.plant.has_value());
  options.picture.check();
  bool const draws = options.picture.path == "-";
  if (options.diff && (draws || options.format != presentation::Format::text)) {
    throw Failure({says::diff_is_output, {{"other", draws ? "-o -" : "--format"}}});
  }
  if (options.tolerance) question.tolerance_mm = positive_number("--tolerance", *options.tolerance, "mm");
  if (options.feed) question.feed_mm_per_min = positive_number("--feed", *options.feed, "mm/min");
  if (options.radius) question.radius_mm = positive_number("--radius", *options.radius, "mm");
  remark_decimal_comma(invocation, "--resonance", question.resonances);
  question.machine.input = options.inputs.front();
  question.measured.insert(question.measured.end(), options.inputs.begin() + 1, options.inputs.end());
  Workspace workspace(overrides_with(options.cycle_time));
  auto const found =
      axisc::suggest(workspace, question,
                     printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!found) return ExitStatus::findings;
  auto& [out, err] = invocation.streams;
  if (found->remark) err.write(warning_line(*found->remark, invocation.language));
  if (found->refusal) {
    err.write(found->helps() ? warning_line(*found->refusal, invocation.language)
                             : Failure(*found->refusal).line(invocation.language));
  }
  if (found->suggestion() == nullptr && !found->damping && !found->ramps) return ExitStatus::findings;
  auto const& picture = options.picture.path;
  if (picture) refuse_overwriting({*picture}, found->files);
  bool const is_text = options.format == presentation::Format::text;
  if (!draws && (!number || !is_text || !found->helps())) {
    print(suggest_answer(*found), options.format, invocation, command_line);
  }
  if (picture) write_picture(suggest_figure(*found, invocation.language), options.picture, invocation);
  if (!found->helps()) return ExitStatus::findings;
  if (!number) return ExitStatus::success;
  out.flush();
  auto const chosen = chosen_suggestion(*found, *number, options.inputs.front());
  if (options.diff) out.write(patch_of(chosen.edits));
  if (!draws && is_text && !options.diff) print(chosen.answer, options.format, invocation, command_line);
  out.flush();
  auto const notes = options.diff ? notes_of(chosen.edits) : write_lists(chosen.edits);
  std::for_each(notes.begin(), notes.end(), printed_notes(invocation));
  return ExitStatus::success;
}

}  // namespace axisc::cli
