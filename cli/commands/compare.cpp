#include "axisc/answers/comparison/compare_answer.hpp"
#include "axisc/answers/execution/recorded_input.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/compare_options.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/printed_errors.hpp"
#include "image/image_readings.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_scope_recording{
    "what a scope recorded: its export, its .svdx, or columns",
    "was ein Scope aufzeichnete: sein Export, seine .svdx oder Spalten"};
constexpr Sentence option_recorded_axis{"the recorded axis (default: the only one)",
                                        "die aufgezeichnete Achse (Standardwert: die einzige)"};
constexpr Sentence option_switched{
    "the control executed COMMAND (#FILTER ...) before that cycle of the recording; for images with kernel "
    "banks",
    "die Steuerung führte BEFEHL (#FILTER ...) vor diesem Zyklus der Aufzeichnung aus; für "
    "Abbilder mit Kernbänken"};
constexpr Sentence option_recorded_program{
    "the recorded NC program: compare its path, not the filters; columns are those of the axes, which --in "
    "names as X=COLUMN, once for each",
    "das aufgezeichnete NC-Programm: seine Bahn vergleichen, nicht die Filter; Spalten sind die der Achsen, "
    "--in nennt sie als X=SPALTE, einmal je Achse"};
constexpr Sentence option_emit{
    "settings: the readings that fit, as \"design\" of axisc.json, with --program as \"motion\"; without a "
    "recording, program: an NC program that tells the readings of \"motion\"; template: what a scope is to "
    "record",
    "settings: die passenden Lesarten als \"design\" für axisc.json, mit --program als \"motion\"; ohne "
    "Aufzeichnung, program: ein NC-Programm, das die Lesarten von \"motion\" zeigt; template: was ein Scope "
    "aufzeichnen soll"};
constexpr Sentence option_net_id{"AMS NetId of the control, for --emit template",
                                 "AMS-NetId der Steuerung, für --emit template"};
constexpr Sentence option_purpose{"what the template's recording is for (default: compare)",
                                  "wofür die Aufzeichnung der Vorlage ist (Standardwert: compare)"};
constexpr Sentence one_setpoint_column{
    "--in names one column, the setpoint before the filters; several are for --program",
    "--in nennt eine Spalte, den Sollwert vor den Filtern; mehrere gibt es nur mit --program"};
constexpr Sentence group_of_program{
    "--group is for --program and --emit program; --axis names the axis whose filters are compared",
    "--group gilt für --program und --emit program; --axis nennt die Achse, deren Filter verglichen werden"};
constexpr Sentence not_recorded_yet{
    "--emit program and --emit template come before a recording: give the machine alone, without one",
    "--emit program und --emit template kommen vor einer Aufzeichnung: nur die Maschine angeben, ohne eine"};
constexpr Sentence no_settings{
    "no settings: the recording does not tell one reading that settings have; `axisc compare` without --emit "
    "says what fits",
    "keine Einstellungen: Die Aufzeichnung ergibt keine eindeutige Lesart, die Einstellungen kennen; `axisc "
    "compare` ohne --emit nennt, was passt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

void declare(CommandLine& command_line, CompareOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_input);
  command_line.argument("RECORDING", options.recording, says::argument_scope_recording);
  command_line.values("--in", "COLUMN", options.columns, says::option_setpoint_column);
  declare_recorded_numbers(command_line, options.numbers);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
  command_line.choice(
      "--emit",
      {{"settings", Emitted::settings}, {"program", Emitted::program}, {"template", Emitted::scope_template}},
      options.emitted, says::option_emit);
  command_line.value("--netid", "A.B.C.D.E.F", options.net_id, says::option_net_id);
  command_line.choice("--for",
                      {{"compare", RecordingPurpose::compare},
                       {"circle", RecordingPurpose::circle},
                       {"identify", RecordingPurpose::identify}},
                      options.purpose, says::option_purpose);
  command_line.value("--program", "PART.nc", options.program, says::option_recorded_program);
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.not_with("--program");
  command_line.value("--axis", "NAME", options.axis, says::option_recorded_axis);
  command_line.value("--out", "COLUMN", options.output, says::option_filtered_column);
  command_line.values("--at", "CYCLE:COMMAND", options.commands, says::option_switched);
  command_line.not_with("");
  declare_format(command_line, options.format);
}

ExitStatus emit_filters(comparison::Comparison const& result, design::Readings const& current,
                        Invocation const& invocation) {
  auto const settings = comparison::settings_of(result, current);
  std::vector<Message> open;
  for (auto const& each : comparison::open_settings(result)) open.push_back(left_open(each));
  auto const text = settings ? std::optional(design_settings(settings->readings)) : std::nullopt;
  bool const is_complete =
      settings && (settings->open.empty() || result.verdict != comparison::Verdict::different);
  return emit_settings(text, open, is_complete, says::no_settings, invocation);
}

ExitStatus compare_filters(CompareOptions const& options, Invocation const& invocation,
                           CommandLine const& command_line) {
  if (options.columns.size() > 1) throw Failure({says::one_setpoint_column});
  if (options.group) throw Failure({says::group_of_program});
  WantedColumns columns{.input = {}, .output = options.output};
  if (!options.columns.empty()) columns.input = options.columns.front();
  Workspace workspace(overrides_with(options.cycle_time));
  auto const input =
      compiled_input(workspace, {.input = *options.input, .alone = options.alone},
                     printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!input) return ExitStatus::findings;
  auto const& image = input->image.contents;
  auto const [axis, recorded] = recorded_input({.input = *options.input,
                                                .recording = *options.recording,
                                                .axis = options.axis,
                                                .commands = options.commands,
                                                .columns = columns,
                                                .units = options.numbers.units(),
                                                .language = invocation.language},
                                               *input);
  if (options.emitted == Emitted::settings) {
    return emit_filters(recorded.result, image::readings_of(image, axis), invocation);
  }
  print(compare_answer(axis_label(image, axis), recorded), options.format, invocation, command_line);
  auto const verdict = recorded.result.verdict;
  bool const agrees = verdict == comparison::Verdict::same || verdict == comparison::Verdict::delayed;
  return agrees ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace

ExitStatus emit_settings(std::optional<std::string> const& settings, std::vector<Message> const& left_open,
                         bool is_complete, SentenceRef nothing, Invocation const& invocation) {
  auto const tell = printed_notes(invocation);
  for (auto const& message : left_open) tell(message);
  if (!settings) {
    tell({nothing});
    return ExitStatus::findings;
  }
  invocation.streams.out.write(*settings);
  return is_complete ? ExitStatus::success : ExitStatus::findings;
}

ExitStatus compare(Invocation const& invocation) {
  CompareOptions options;
  CommandLine command_line("compare", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  if (options.emitted == Emitted::program || options.emitted == Emitted::scope_template) {
    if (options.recording || options.program) throw Failure({says::not_recorded_yet});
    return options.emitted == Emitted::program ? emit_program(options, invocation, command_line)
                                               : emit_template(options, invocation, command_line);
  }
  command_line.require(options.recording.has_value(), "RECORDING");
  if (options.program) return compare_motion(options, invocation, command_line);
  return compare_filters(options, invocation, command_line);
}

}  // namespace axisc::cli
