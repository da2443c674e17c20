#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/suggestion/damping_formats.hpp"
#include "axisc/answers/suggestion/measured_resonances.hpp"
#include "axisc/answers/suggestion/resonance_words.hpp"
#include "axisc/answers/suggestion/suggest_figure.hpp"
#include "axisc/answers/suggestion/suggest_formats.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "axisc/workspace/changeable_files.hpp"
#include "axisc/workspace/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/picture_output.hpp"
#include "cli/output/printed_errors.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/writers/unified_diff.hpp"
#include "validator/loading/build_version.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence option_axis{"the vibrating axis", "die Achse, die schwingt"};
constexpr Sentence option_resonance{"up to three natural frequencies, each perhaps with its damping ratio",
                                    "bis zu drei Eigenfrequenzen, jede vielleicht mit ihrem Dämpfungsgrad"};
constexpr Sentence option_measured{
    "find them in a measurement instead: two signals over time, a frequency response or a spectrum (CSV)",
    "sie stattdessen in einer Messung finden: zwei Signale über der Zeit, ein Frequenzgang oder ein Spektrum "
    "(CSV)"};
constexpr Sentence option_in{"column of the measurement's input (torque, or setpoint)",
                             "Spalte des Eingangs der Messung (Drehmoment oder Sollwert)"};
constexpr Sentence option_out{"column of its output (velocity, or position)",
                              "Spalte ihres Ausgangs (Geschwindigkeit oder Position)"};
constexpr Sentence one_source{"name either --resonance or --measured",
                              "entweder --resonance oder --measured angeben"};
constexpr Sentence of_measured{"--in and --out belong to --measured", "--in und --out gehören zu --measured"};
constexpr Sentence option_plant{
    "drive and mechanics of the axis (JSON): compare Improved Position Control too",
    "Antrieb und Mechanik der Achse (JSON): auch die optimierte Lageregelung vergleichen"};
constexpr Sentence option_tolerance{"allowed axis error in mm, on the circle and as AX_DEV (default: 10 µm)",
                                    "erlaubter Achsfehler in mm, auf dem Kreis und als AX_DEV (Standardwert: "
                                    "10 µm)"};
constexpr Sentence option_feed{"feed rate in mm/min (default: 4000)",
                               "Vorschub in mm/min (Standardwert: 4000)"};
constexpr Sentence option_radius{
    "circle on which the feed keeps the tolerance, in mm (default: 10)",
    "Kreis, auf dem der Vorschub die Toleranz einhält, in mm (Standardwert: 10)"};
constexpr Sentence option_goal{"what counts more: which suggestion is recommended (default: balanced)",
                               "was mehr zählt: welcher Vorschlag empfohlen wird (Standardwert: ausgewogen)"};
constexpr Sentence option_picture{
    "also draw the settings: FILE.svg, FILE.html; - draws an SVG instead of the text",
    "die Einstellungen auch zeichnen: DATEI.svg, DATEI.html; - zeichnet ein SVG statt "
    "des Texts"};
constexpr Sentence option_apply{"write suggestion 1, 2, 3 or, with --plant, 4 into the lists",
                                "Vorschlag 1, 2, 3 oder, mit --plant, 4 in die Listen schreiben"};
constexpr Sentence option_diff{"with --apply: show the patch, write nothing",
                               "mit --apply: den Patch zeigen, nichts schreiben"};
constexpr Sentence diff_needs_apply{"--diff shows what --apply N would write: add --apply N",
                                    "--diff zeigt, was --apply N schreiben würde: --apply N ergänzen"};
constexpr Sentence diff_is_output{"--diff writes a patch to standard output: leave out {other}",
                                  "--diff schreibt einen Patch auf die Standardausgabe: {other} weglassen"};
constexpr Sentence bad_apply{"--apply needs 1, 2, 3 or 4, not \"{value}\"",
                             "--apply braucht 1, 2, 3 oder 4, nicht \"{value}\""};
constexpr Sentence apply_needs_plant{"--apply 4 is Improved Position Control: it needs --plant",
                                     "--apply 4 ist die optimierte Lageregelung: dafür --plant angeben"};
constexpr Sentence nothing_to_apply{"there is no suggestion {number} to write",
                                    "es gibt keinen Vorschlag {number}, der geschrieben werden könnte"};
constexpr Sentence nothing_to_draw{"there is nothing to draw: no filters are suggested",
                                   "es gibt nichts zu zeichnen: es werden keine Filter vorgeschlagen"};
constexpr Sentence not_editable{"{file} cannot be edited: write the lines into it by hand",
                                "{file} kann nicht bearbeitet werden: die Zeilen von Hand eintragen"};
constexpr Sentence not_named{
    "{file} lies outside what the command line names: write the lines into it by hand",
    "{file} liegt außerhalb dessen, was die Befehlszeile nennt: die Zeilen von Hand eintragen"};
constexpr Sentence has_findings{
    "suggestion {number} is not written: the lists would have findings ({codes})",
    "Vorschlag {number} wird nicht geschrieben: die Listen hätten Befunde ({codes})"};
constexpr Sentence written{"written: {file}", "geschrieben: {file}"};
constexpr Sentence nothing_written{"nothing to write: the lists have this setting already",
                                   "nichts zu schreiben: die Listen haben diese Einstellung schon"};
constexpr Sentence option_format{"output format (default: text)", "Ausgabeformat (Standardwert: text)"};
constexpr Sentence not_positive{"{option} needs a number above 0, not \"{value}\"",
                                "{option} braucht eine Zahl über 0, nicht \"{value}\""};
constexpr Sentence no_channel{
    "axis {axis} belongs to no channel: its setpoint passes no filter of a path",
    "Achse {axis} gehört zu keinem Kanal: ihr Sollwert läuft durch keinen Bahnfilter"};
constexpr Sentence no_acceleration{"axis {axis} has no acceleration: set a_max (P-AXIS-00008)",
                                   "Achse {axis} hat keine Beschleunigung: a_max (P-AXIS-00008) setzen"};
constexpr Sentence feed_limited{
    "axis {axis} moves at most at {limit} mm/min (vb_max, P-AXIS-00212): this feed counts",
    "Achse {axis} fährt höchstens mit {limit} mm/min (vb_max, P-AXIS-00212): dieser "
    "Vorschub zählt"};
constexpr Sentence too_strict{
    "none of {count} settings keeps {tolerance} mm on a circle of {radius} mm at {feed} mm/min; allow a "
    "larger "
    "tolerance, or a lower feed",
    "keine von {count} Einstellungen hält {tolerance} mm auf einem Kreis von {radius} mm bei {feed} mm/min "
    "ein; "
    "eine größere Toleranz oder einen kleineren Vorschub zulassen"};
constexpr Sentence too_weak{
    "of {count} settings that keep {tolerance} mm on a circle of {radius} mm at {feed} mm/min, the best "
    "leaves {left} % "
    "of the vibration: too much to suggest it; allow a larger tolerance, or a lower feed",
    "von {count} Einstellungen, die {tolerance} mm auf einem Kreis von {radius} mm bei {feed} mm/min "
    "einhalten, lässt "
    "die beste {left} % der Schwingung: zu viel für einen Vorschlag; eine größere Toleranz oder einen "
    "kleineren "
    "Vorschub zulassen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Format : std::uint8_t { text, json };

struct SuggestOptions {
  std::optional<std::string> machine, axis, resonance, measured, in, out, plant, tolerance, feed, radius,
      cycle_time, apply;
  bool diff = false;
  bool alone = false;
  PictureTarget picture;
  std::optional<tuning::Goal> goal;
  Format format = Format::text;
};

void declare(CommandLine& command_line, SuggestOptions& options) {
  using Goal = std::optional<tuning::Goal>;
  command_line.argument("MACHINE", options.machine, says::argument_input);
  command_line.value("--axis", "NAME", options.axis, says::option_axis);
  command_line.value("--resonance", "HZ[:DAMPING][,...]", options.resonance, says::option_resonance);
  command_line.value("--measured", "FILE.csv", options.measured, says::option_measured);
  command_line.value("--in", "COLUMN", options.in, says::option_in);
  command_line.value("--out", "COLUMN", options.out, says::option_out);
  command_line.value("--plant", "PLANT.json", options.plant, says::option_plant);
  command_line.value("--tolerance", "MM", options.tolerance, says::option_tolerance);
  command_line.value("--feed", "MM_PER_MIN", options.feed, says::option_feed);
  command_line.value("--radius", "MM", options.radius, says::option_radius);
  command_line.choice("--goal",
                      {{"surface", Goal(tuning::Goal::surface)},
                       {"accuracy", Goal(tuning::Goal::accuracy)},
                       {"speed", Goal(tuning::Goal::speed)}},
                      options.goal, says::option_goal);
  command_line.value("-o,--output", "FILE", options.picture.path, says::option_picture);
  command_line.value("--apply", "N", options.apply, says::option_apply);
  command_line.flag("--diff", options.diff, says::option_diff);
  command_line.choice("--format", {{"text", Format::text}, {"json", Format::json}}, options.format,
                      says::option_format);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
}

double positive(std::string const& option, std::optional<std::string> const& word, double usual) {
  if (!word) return usual;
  auto const value = parse_finite(*word);
  if (value && *value > 0) return *value;
  throw Failure({.sentence = says::not_positive, .arguments = {{"option", option}, {"value", *word}}});
}

std::size_t axis_named(machine::Machine const& machine, std::string const& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    if (machine.axes[i].name == name) return i;
    names.push_back(machine.axes[i].name);
  }
  throw unknown_axis(name, names);
}

/// The channel of an axis; of a gantry slave that of its master.
std::size_t group_of(machine::Machine const& machine, std::size_t axis) {
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& axes = machine.groups[i].axes;
    if (std::find(axes.begin(), axes.end(), axis) != axes.end()) return i;
  }
  if (machine.axes[axis].gantry_master) return group_of(machine, *machine.axes[axis].gantry_master);
  throw Failure({.sentence = says::no_channel, .arguments = {{"axis", machine.axes[axis].name}}});
}

struct Wishes {
  double tolerance_mm, feed, radius_mm;
};

tuning::Task task_of(SuggestOptions const& options, Wishes const& wishes, SuggestionSubject const& subject,
                     std::vector<tuning::Resonance> resonances, Invocation const& invocation) {
  constexpr double mm_per_min_of_um_per_s = 0.06;
  auto const& machine = subject.machine;
  auto const& axis = machine.axes[subject.axis];
  double const T = machine.cycle_time.seconds();
  if (!(axis.acceleration_limit > 0)) {
    throw Failure({.sentence = says::no_acceleration, .arguments = {{"axis", axis.name}}});
  }
  double feed = wishes.feed;
  double const limit = axis.velocity_limit * mm_per_min_of_um_per_s;
  if (limit > 0 && feed > limit) {
    feed = limit;
    invocation.streams.err.write(
        warning_line({.sentence = says::feed_limited,
                      .arguments = {{"axis", axis.name}, {"limit", format_rounded(limit, 6)}}},
                     invocation.language));
  }
  auto const& build = subject.loaded.build;
  bool const knows_fir = !build || !(*build < validator::builds::fir_command);
  return {.cycle_time = machine.cycle_time,
          .resonances = std::move(resonances),
          .velocity = path_velocity(feed, machine.cycle_time),
          .acceleration = axis.acceleration_limit * motion::units_per_mm * T * T,
          .tolerance = wishes.tolerance_mm * motion::units_per_mm,
          .radius = wishes.radius_mm * motion::units_per_mm,
          .goal = options.goal,
          .family = knows_fir ? machine::KernelFamily::fir : machine::KernelFamily::hsc,
          .readings = subject.loaded.readings};
}

/// A warning where something else helps.
void say_nothing_helps(NoSuggestion const& none, Wishes const& wishes, bool is_error,
                       Invocation const& invocation) {
  bool const keeps = none.keeps > 0;
  constexpr double percent = 100;
  Message const message{.sentence = keeps ? SentenceRef(says::too_weak) : SentenceRef(says::too_strict),
                        .arguments = {{"count", std::to_string(keeps ? none.keeps : none.looked_at)},
                                      {"tolerance", exact_number(wishes.tolerance_mm)},
                                      {"radius", exact_number(wishes.radius_mm)},
                                      {"feed", format_rounded(wishes.feed, 6)},
                                      {"left", format_rounded(none.least_vibration * percent, 3)}}};
  invocation.streams.err.write(is_error ? Failure(message).line(invocation.language)
                                        : warning_line(message, invocation.language));
}

/// Number of the suggestion that --apply names.
std::optional<std::size_t> applied(std::optional<std::string> const& word, bool has_plant) {
  if (!word) return std::nullopt;
  auto const number = parse_count(*word);
  if (!number || *number < 1 || *number > damping_number) {
    throw Failure({.sentence = says::bad_apply, .arguments = {{"value", *word}}});
  }
  if (*number == damping_number && !has_plant) {
    throw Failure({.sentence = says::apply_needs_plant, .arguments = {}});
  }
  return *number;
}

void refuse_mixture(SuggestOptions const& options) {
  if (!options.diff) return;
  if (!options.apply) throw Failure({.sentence = says::diff_needs_apply, .arguments = {}});
  if (options.format == Format::json) {
    throw Failure({.sentence = says::diff_is_output, .arguments = {{"other", "--format json"}}});
  }
  if (options.picture.path == "-") {
    throw Failure({.sentence = says::diff_is_output, .arguments = {{"other", "-o -"}}});
  }
}

/// Every list or none: what was written is taken back where a later one cannot be. With `diff` none: the
/// patch is printed.
void apply(ListEdits const& edits, std::vector<std::string> const& findings, std::size_t number,
           std::string const& named, bool diff, Invocation const& invocation) {
  auto const& [original, edited, refused] = edits;
  if (refused) throw Failure({.sentence = says::not_editable, .arguments = {{"file", *refused}}});
  if (!findings.empty()) {
    std::string codes;
    for (auto const& code : findings) codes += (codes.empty() ? "" : ", ") + code;
    throw Failure({.sentence = says::has_findings,
                   .arguments = {{"number", std::to_string(number)}, {"codes", codes}}});
  }
  ChangeableFiles const changeable({named});
  for (auto const& [path, bytes] : edited) {
    if (!changeable.contains(path)) {
      throw Failure({.sentence = says::not_named, .arguments = {{"file", path}}});
    }
  }
  auto const tell = [&](Message const& message) {
    invocation.streams.err.write("axisc: " + render(message, invocation.language) + "\n");
  };
  if (diff) {
    for (auto const& [path, bytes] : edited) {
      invocation.streams.out.write(unified_diff(path, original.at(path), bytes));
    }
    if (edited.empty()) tell({.sentence = says::nothing_written, .arguments = {}});
    return;
  }
  std::vector<std::string> done;
  try {
    for (auto const& [path, bytes] : edited) {
      replace_content(path, original.at(path), bytes);
      done.push_back(path);
    }
  } catch (Failure const&) {
    for (auto const& path : done) replace_content(path, edited.at(path), original.at(path));
    throw;
  }
  for (auto const& path : done) tell({.sentence = says::written, .arguments = {{"file", path}}});
  if (done.empty()) tell({.sentence = says::nothing_written, .arguments = {}});
}

}  // namespace

ExitStatus suggest(Invocation const& invocation) {
  SuggestOptions options;
  CommandLine command_line("suggest", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.machine.has_value(), "MACHINE");
  if (options.resonance.has_value() == options.measured.has_value()) {
    throw Failure({.sentence = says::one_source, .arguments = {}});
  }
  if (!options.measured && (options.in || options.out)) {
    throw Failure({.sentence = says::of_measured, .arguments = {}});
  }
  auto const chosen = applied(options.apply, options.plant.has_value());
  options.picture.check();
  refuse_mixture(options);
  Wishes const wishes{.tolerance_mm = positive("--tolerance", options.tolerance, 0.01),
                      .feed = positive("--feed", options.feed, 4000),
                      .radius_mm = positive("--radius", options.radius, 10)};

  SettingsFinder settings;
  CheckJob job;
  job.options.cycle_time = asked_cycle_time(options.cycle_time);
  job.settings = &settings;
  DiskFiles disk(*options.machine == "-");
  auto const [path, list] =
      machine_of_input({.input = *options.machine, .cycle_time = {}, .alone = options.alone}, job, disk);
  SourceSet sources;
  std::optional<validator::LoadedMachine> loaded;
  auto const checked = check_machine(
      job, path, disk, printed_errors(invocation, use_color(command_line.color(), system::Stream::error)),
      sources, loaded);
  if (!checked) return ExitStatus::findings;
  require_cycle_time(path, *checked);
  auto const& machine = *checked->machine;
  if (options.picture.path) {
    auto inputs = checked->files;
    if (options.measured) inputs.push_back(*options.measured);
    if (options.plant) inputs.push_back(*options.plant);
    refuse_overwriting({*options.picture.path}, inputs);
  }
  auto const listed = axis_of_list(*loaded, sources, list);
  command_line.require(options.axis || listed, "--axis");
  auto const axis = options.axis ? axis_named(machine, *options.axis) : *listed;
  SuggestionSubject const subject{.path = path,
                                  .job = job,
                                  .loaded = *loaded,
                                  .sources = sources,
                                  .machine = machine,
                                  .group = group_of(machine, axis),
                                  .axis = axis};
  MeasuredResonances measured;
  std::vector<tuning::Resonance> resonances;
  if (options.measured) {
    constexpr double below_nyquist = 0.9;
    measured = measured_resonances(*options.measured, {.in = options.in, .out = options.out},
                                   below_nyquist * machine.cycle_time.nyquist().value);
    if (measured.refusal) {
      invocation.streams.err.write(Failure(*measured.refusal).line(invocation.language));
      return ExitStatus::findings;
    }
    for (auto const& peak : measured.peaks) {
      resonances.push_back(
          {.frequency = peak.frequency, .damping = peak.damping, .uncertainty = peak.frequency_uncertainty});
    }
  } else {
    resonances = read_resonances(*options.resonance, machine.cycle_time);
  }
  auto const task = task_of(options, wishes, subject, std::move(resonances), invocation);
  std::optional<DampingAnswer> damping;
  if (options.plant) damping = damping_for(subject, task, *options.plant);
  auto& out = invocation.streams.out;
  bool const wants_json = options.format == Format::json;
  auto const apply_damping = [&]() {
    if (!damping->damping()) {
      throw Failure({.sentence = says::nothing_to_apply, .arguments = {{"number", std::to_string(*chosen)}}});
    }
    if (!wants_json && !options.diff) out.write(chosen_text(*damping, invocation.language));
    apply(damping->edits, damping->findings, *chosen, *options.machine, options.diff, invocation);
  };

  auto answer = suggestion_for(subject, task);
  if (auto const* const none = std::get_if<NoSuggestion>(&answer)) {
    say_nothing_helps(*none, wishes, !damping || !damping->damping(), invocation);
    if (!damping) return ExitStatus::findings;
    if (options.picture.path) throw Failure({.sentence = says::nothing_to_draw, .arguments = {}});
    if (wants_json) out.write(suggest_json(subject, *none, *damping, task));
    bool const tells_all = !chosen || !damping->damping();
    if (!wants_json && tells_all) out.write(damping_text(*damping, subject, task, invocation.language));
    if (!damping->damping()) return ExitStatus::findings;
    if (!chosen) return ExitStatus::success;
    out.flush();
    if (*chosen != damping_number) {
      throw Failure({.sentence = says::nothing_to_apply, .arguments = {{"number", std::to_string(*chosen)}}});
    }
    apply_damping();
    return ExitStatus::success;
  }
  auto& suggestion = std::get<Suggestion>(answer);
  if (options.measured) suggestion.measured = std::move(measured);
  if (options.picture.path != "-") {
    if (wants_json) {
      out.write(suggest_json(suggestion, damping ? &*damping : nullptr));
    } else if (!chosen) {
      out.write(suggest_text(suggestion, invocation.language));
      if (damping) out.write("\n" + damping_text(*damping, subject, task, invocation.language));
    }
  }
  if (options.picture.path) {
    write_picture(suggest_figure(suggestion, invocation.language), options.picture, invocation);
  }
  if (!chosen) return ExitStatus::success;
  out.flush();
  if (*chosen == damping_number) {
    apply_damping();
  } else {
    auto const index = suggestion.proposed.at(*chosen - 1);
    auto const& alternative = suggestion.alternatives.at(index);
    if (!wants_json && !options.diff && options.picture.path != "-") {
      out.write(chosen_text(suggestion, index, invocation.language));
      out.flush();
    }
    apply(alternative.edits, alternative.findings, *chosen, *options.machine, options.diff, invocation);
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
