#include "axisc/answers/identify/identified_plant.hpp"
#include "axisc/answers/identify/identify_answer.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/recorded_numbers.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_identify{"the machine, then recordings of the axis in ordinary motion",
                                     "die Maschine, dann Aufzeichnungen der Achse in gewöhnlicher Bewegung"};
constexpr Sentence option_identified{"the recorded axis", "die aufgezeichnete Achse"};
constexpr Sentence option_identify_actual{"column of the actual position", "Spalte der Istposition"};
constexpr Sentence option_force{"column of the torque or force", "Spalte des Drehmoments oder der Kraft"};
constexpr Sentence option_emit_plant{"write a plant file instead of the answer",
                                     "statt der Antwort eine Streckendatei schreiben"};
constexpr Sentence option_known{
    "with --emit plant: a value of the plant that is known otherwise, such as motor_mass_kg=120",
    "mit --emit plant: ein Wert der Strecke, der anderswoher bekannt ist, etwa motor_mass_kg=120"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Emitted : std::uint8_t { answer, plant };

struct IdentifyOptions {
  IdentifyQuestion question;
  std::vector<std::string> inputs, known;
  RecordedNumbers numbers;
  std::optional<std::string> cycle_time;
  Emitted emitted = Emitted::answer;
  presentation::Format format = presentation::Format::text;
};

void declare(CommandLine& command_line, IdentifyOptions& options) {
  auto& question = options.question;
  command_line.arguments("MACHINE RECORDING...", options.inputs, says::argument_identify);
  command_line.value("--axis", "NAME", question.axis, says::option_identified);
  command_line.value("--actual", "COLUMN", question.columns.actual, says::option_identify_actual);
  command_line.value("--force", "COLUMN", question.columns.force, says::option_force);
  declare_recorded_numbers(command_line, options.numbers);
  command_line.choice("--emit", {{"plant", Emitted::plant}}, options.emitted, says::option_emit_plant);
  command_line.only_with("--emit");
  command_line.values("--known", "KEY=VALUE", options.known, says::option_known);
  command_line.only_with({});
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, question.machine.alone);
  declare_format(command_line, options.format);
}

}  // namespace

ExitStatus identify(Invocation const& invocation) {
  IdentifyOptions options;
  CommandLine command_line("identify", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!options.inputs.empty(), "MACHINE");
  auto& question = options.question;
  question.machine.input = options.inputs.front();
  question.recordings.assign(options.inputs.begin() + 1, options.inputs.end());
  question.units = options.numbers.units();
  std::vector<PlantValue> known;
  for (auto const& text : options.known) known.push_back(read_plant_value(text));
  Workspace workspace(overrides_with(options.cycle_time));
  auto const found =
      identified_axis(workspace, question,
                      printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!found) return ExitStatus::findings;
  if (options.emitted == Emitted::plant) {
    invocation.streams.out.write(identified_plant(*found, std::move(known)));
  } else {
    print(identify_answer(*found), options.format, invocation, command_line);
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
