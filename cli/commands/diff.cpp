#include "axisc/answers/difference/difference_answer.hpp"
#include "axisc/asked/quantities.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_diff{
    "two folders, start-up lists, machine files, lists or images, also mixed; or one, with two axes",
    "zwei Ordner, Hochlauflisten, Maschinendateien, Listen oder Abbilder, auch gemischt; oder eins mit zwei "
    "Achsen"};
constexpr Sentence option_compared_axes{
    "only this axis: its name in programs, its number, or its list; given twice: the first of OLD with the "
    "second of NEW, or two axes of one machine",
    "nur diese Achse: ihr Name im Programm, ihre Nummer oder ihre Liste; zweimal: die erste von ALT mit der "
    "zweiten von NEU, oder zwei Achsen einer Maschine"};
constexpr Sentence option_all_differences{
    "also show parameters that one side sets to the default of the other, and those in which axes of one "
    "machine must differ (number, name, drive address)",
    "auch Parameter zeigen, die eine Seite auf den Standardwert der anderen setzt, und solche, in denen sich "
    "Achsen einer Maschine unterscheiden müssen (Nummer, Name, Antriebsadresse)"};
constexpr Sentence one_input{
    "there is nothing to compare {input} with; name a second input, or two of its axes: --axis X --axis Y",
    "es fehlt, womit {input} zu vergleichen ist; eine zweite Eingabe nennen oder zwei ihrer Achsen: --axis X "
    "--axis Y"};
constexpr Sentence too_many{"`diff` compares two inputs, and at most two axes of them",
                            "`diff` vergleicht zwei Eingaben und höchstens zwei Achsen davon"};
constexpr Sentence option_feed_of_corner{"path feed in mm/min for the corner (default: 1000)",
                                         "Bahnvorschub in mm/min für die Ecke (Standardwert: 1000)"};
constexpr Sentence option_exit_code{"exit status 1 if something changed",
                                    "Rückgabewert 1, wenn sich etwas geändert hat"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct DiffOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> axes;
  std::vector<std::string> schema_files;
  std::optional<std::string> cycle_time;
  std::optional<std::string> feed;
  presentation::Format format = presentation::Format::text;
  bool all = false;
  bool exit_code = false;
};

void declare(CommandLine& command_line, DiffOptions& options) {
  command_line.arguments("OLD NEW", options.inputs, says::argument_diff);
  command_line.values("--axis", "NAME", options.axes, says::option_compared_axes);
  command_line.flag("--all", options.all, says::option_all_differences);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  command_line.value("--feed", "MM_PER_MIN", options.feed, says::option_feed_of_corner);
  declare_format(command_line, options.format);
  declare_schema(command_line, options.schema_files);
  command_line.flag("--exit-code", options.exit_code, says::option_exit_code);
}

MachineDifference compare(DiffOptions const& options, ComparedSides const& sides) {
  if (options.axes.empty()) return compare_machines(*sides.before, *sides.after, options.all);
  return compare_axes(*sides.before, axis_called(*sides.before, options.axes.front()), *sides.after,
                      axis_called(*sides.after, options.axes.back()), options.all);
}

/// Two inputs, or two axes of one.
void require_two_sides(CommandLine const& command_line, DiffOptions const& options) {
  command_line.require(!options.inputs.empty(), "OLD NEW");
  if (options.inputs.size() > 2 || options.axes.size() > 2) {
    throw Failure({says::too_many});
  }
  if (options.inputs.size() == 1 && options.axes.size() != 2) {
    throw Failure({says::one_input, {{"input", options.inputs.front()}}});
  }
}

}  // namespace

ExitStatus diff(Invocation const& invocation) {
  DiffOptions options;
  CommandLine command_line("diff", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  require_two_sides(command_line, options);
  constexpr double feed_otherwise = 1000;
  double const feed = options.feed ? positive_number("--feed", *options.feed, "mm/min") : feed_otherwise;
  Workspace workspace(overrides_with(options.cycle_time, options.schema_files));
  bool const color = use_color(command_line.color(), system::Stream::error);
  auto const sides = compared_sides(workspace, options.inputs.front(), options.inputs.back(),
                                    printed_errors(invocation, color));
  if (!sides) return ExitStatus::findings;

  auto const difference = compare(options, *sides);
  bool const of_one_machine = difference.of_one_machine;
  print(difference_answer(
            {.before = of_one_machine ? axis_called(*sides->before, options.axes[0]).name : options.inputs[0],
             .after = of_one_machine ? axis_called(*sides->after, options.axes[1]).name : options.inputs[1],
             .difference = difference,
             .feed_mm_per_min = feed,
             .read_by_both = sides->read_by_both}),
        options.format, invocation, command_line);
  bool const has_errors = !sides->before->image || !sides->after->image;
  return has_errors || (options.exit_code && !difference.empty()) ? ExitStatus::findings
                                                                  : ExitStatus::success;
}

}  // namespace axisc::cli
