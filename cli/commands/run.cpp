#include "axisrt.h"
#include "cli/codes.hpp"
#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/execution/execution.hpp"
#include "cli/files/image_file.hpp"
#include "cli/files/output_file.hpp"
#include "cli/options/quantities.hpp"
#include "cli/execution/stimulus.hpp"

#include <memory>

namespace axisc::cli {

namespace {

constexpr std::uint64_t default_cycles = 256;
constexpr std::uint64_t default_record_cycles = 1000;
constexpr std::uint64_t most_record_cycles = 10'000'000;

struct RunWords {
  std::optional<std::string> image;
  std::optional<std::string> input;
  std::optional<std::string> signal;
  std::optional<std::string> amplitude;
  std::optional<std::string> cycles;
  std::optional<std::string> reset;
  std::optional<std::string> output;
  std::vector<std::string> commands;
  std::optional<std::string> port;
  std::optional<std::string> level;
  std::optional<std::string> record;
  std::optional<std::string> record_cycles;
  bool quiet = false;
};

void declare(CommandLine& command_line, RunWords& words) {
  command_line.argument("IMAGE.axim", words.image, Text::cli_arg_image);
  command_line.value("--input", "FILE.csv", words.input, Text::cli_opt_input);
  command_line.value("--signal", "SIGNAL", words.signal, Text::cli_opt_signal);
  command_line.value("--amplitude", "A", words.amplitude, Text::cli_opt_amplitude);
  command_line.value("--cycles", "N", words.cycles, Text::cli_opt_cycles);
  command_line.value("--port", "setpoint|interface|velocity", words.port, Text::cli_opt_port);
  command_line.value("--reset", "POSITION", words.reset, Text::cli_opt_reset);
  command_line.values("--at", "CYCLE:COMMAND", words.commands, Text::cli_opt_at);
  command_line.value("--level", level_words, words.level, Text::cli_opt_level);
  command_line.value("-o,--output", "FILE.csv", words.output, Text::cli_opt_csv_output);
  command_line.value("--record", "FILE.axrd", words.record, Text::cli_opt_record);
  command_line.value("--record-cycles", "N", words.record_cycles, Text::cli_opt_record_cycles);
  command_line.flag("-q,--quiet", words.quiet, Text::cli_opt_run_quiet);
}

double number(std::optional<std::string> const& word, char const* option, double otherwise) {
  if (!word) return otherwise;
  auto const value = parse_number(*word);
  if (!value) {
    throw Failure({.text = Text::cli_bad_number, .arguments = {{"option", option}, {"value", *word}}});
  }
  return *value;
}

std::uint64_t count(std::optional<std::string> const& word, char const* option, std::uint64_t otherwise) {
  if (!word) return otherwise;
  auto const value = parse_count(*word);
  if (!value) {
    throw Failure({.text = Text::cli_bad_count, .arguments = {{"option", option}, {"value", *word}}});
  }
  return *value;
}

/// How many cycles shall be recorded; none without `--record`.
std::optional<std::uint32_t> cycles_to_record(RunWords const& words) {
  if (!words.record && words.record_cycles) {
    throw Failure({.text = Text::cli_record_missing, .arguments = {}});
  }
  if (!words.record) return std::nullopt;
  auto const cycles = count(words.record_cycles, "--record-cycles", default_record_cycles);
  if (cycles >= 1 && cycles <= most_record_cycles) return static_cast<std::uint32_t>(cycles);
  throw Failure({.text = Text::cli_bad_count,
                 .arguments = {{"option", "--record-cycles"}, {"value", *words.record_cycles}}});
}

Port port_of(RunWords const& words) {
  for (auto const port : {Port::setpoint, Port::interface, Port::velocity}) {
    if (!words.port || *words.port == port_name(port)) return port;
  }
  throw Failure(
      {.text = Text::cli_bad_choice,
       .arguments = {
           {"option", "--port"}, {"value", *words.port}, {"choices", "setpoint, interface, velocity"}}});
}

/// What belongs to --signal says nothing about a file.
void refuse_mixture(RunWords const& words) {
  if (!words.input) return;
  for (auto const& [given, option] : {std::pair(words.signal.has_value(), "--signal"),
                                      {words.amplitude.has_value(), "--amplitude"},
                                      {words.cycles.has_value(), "--cycles"},
                                      {words.port.has_value(), "--port"}}) {
    if (given) throw Failure({.text = Text::cli_signal_and_input, .arguments = {{"option", option}}});
  }
}

/// Reads a file piece by piece; it is open as long as the source lives.
ByteSource open_source(std::string const& path) {
  auto const fail = [path](system::Error const& error) {
    throw Failure({.text = Text::ax9001, .arguments = {{"file", path}, {"reason", system::text_of(error)}}},
                  cannot_read);
  };
  auto opened = path == "-" ? system::File::standard_input() : system::File::open(path, system::Access::read);
  if (auto const* const error = std::get_if<system::Error>(&opened)) fail(*error);
  auto file = std::make_shared<system::File>(std::get<system::File>(std::move(opened)));
  return [file = std::move(file), fail](std::span<char> buffer) -> std::size_t {
    auto const got = file->read(buffer);
    if (auto const* const error = std::get_if<system::Error>(&got)) fail(*error);
    return std::get<std::size_t>(got);
  };
}

std::unique_ptr<Stimulus> make_stimulus(RunWords const& words, image::ImageContents const& image) {
  if (words.input) return std::make_unique<CsvStimulus>(image, *words.input, open_source(*words.input));
  auto const text = words.signal.value_or("step");
  auto const signal = Signal::parse(text);
  if (!signal) throw Failure({.text = Text::cli_bad_signal, .arguments = {{"value", text}}});
  auto stimulus = std::make_unique<SignalStimulus>(
      image, SignalStimulus::Facts{.signal = *signal,
                                   .amplitude = number(words.amplitude, "--amplitude", 1),
                                   .cycles = count(words.cycles, "--cycles", default_cycles),
                                   .port = port_of(words)});
  if (stimulus->channels().empty()) {
    Text const text_of_port =
        port_of(words) == Port::velocity ? Text::cli_no_velocities : Text::cli_no_interface_filter;
    throw Failure({.text = text_of_port, .arguments = {{"file", *words.image}}});
  }
  return stimulus;
}

void write_recording(std::string const& path, std::vector<std::byte> const& bytes) {
  OutputFile target(path);
  target.write({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
  target.commit();
}

void report(Occurrences const& occurrences, Text text, Invocation const& invocation) {
  if (occurrences.count == 0) return;
  invocation.streams.err.write(
      warning_line({.text = text,
                    .arguments = {{"count", std::to_string(occurrences.count)},
                                  {"cycle", std::to_string(occurrences.first_cycle)}}},
                   invocation.language));
}

}  // namespace

ExitStatus run(Invocation const& invocation) {
  RunWords words;
  CommandLine command_line("run", Text::cli_run_purpose, Text::cli_run_examples, invocation.language);
  declare(command_line, words);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(words.image.has_value(), "IMAGE.axim");
  refuse_mixture(words);
  auto const port = port_of(words);
  double const position = number(words.reset, "--reset", 0);
  auto const recorded_cycles = cycles_to_record(words);
  auto const file = load_image(*words.image);
  auto const stimulus = make_stimulus(words, file.contents);
  Execution execution(*words.image, start_runtime(*words.image, file, level_of(words.level)), file.contents,
                      *stimulus,
                      read_timed_commands(words.commands, file, *words.image, invocation.language));
  if (recorded_cycles) execution.record(*recorded_cycles);
  execution.reset(position, port);
  Noticed noticed;
  if (words.output) {
    OutputFile target(*words.output);
    noticed = execution.go([&target](std::string_view text) { target.write(text); });
    target.commit();
  } else {
    noticed = execution.go([&out](std::string_view text) { out.write(text); });
  }
  if (words.record) write_recording(*words.record, execution.recording());
  if (words.quiet) return ExitStatus::success;
  report(noticed.refused, Text::cli_refused_setpoints, invocation);
  report(noticed.jumps, Text::cli_jumps, invocation);
  return ExitStatus::success;
}

}  // namespace axisc::cli
