#include "cli/checking.hpp"
#include "cli/commands.hpp"
#include "cli/depfile.hpp"
#include "cli/disk_files.hpp"
#include "cli/finding_report.hpp"
#include "cli/machine_outline.hpp"
#include "cli/output_file.hpp"
#include "cli/quantities.hpp"
#include "cli/report_context.hpp"
#include "cli/settings.hpp"
#include "codegen/image_writer.hpp"
#include "diagnostics/writers.hpp"

#include <limits>
#include <utility>

namespace axisc::cli {

namespace {

struct CompileWords {
  CheckingWords checking;
  std::optional<std::string> input;
  std::optional<std::string> output;
  std::optional<std::string> depfile;
  std::optional<std::string> image_version;
  bool strip = false;
};

codegen::ImageOptions image_options(CompileWords const& words) {
  codegen::ImageOptions options;
  options.strip = words.strip;
  if (!words.image_version) return options;
  auto const version = parse_count(*words.image_version);
  if (!version || *version > std::numeric_limits<std::uint32_t>::max()) {
    throw Failure({.text = Text::cli_bad_image_version, .arguments = {{"value", *words.image_version}}});
  }
  options.image_version = static_cast<std::uint32_t>(*version);
  return options;
}

/// An image for a guessed cycle time would move every frequency.
void require_cycle_time(std::string const& input, validator::CheckResult const& result) {
  bool const is_machine = has_extension(input, ".json");
  // A machine file with mistakes is judged first: the cycle time may be one of them.
  if (result.cycle_time_known || (is_machine && !result.machine)) return;
  throw Failure({.text = is_machine ? Text::cli_machine_cycle_time_missing : Text::cli_cycle_time_missing,
                 .arguments = {{"file", input}}});
}

/// A configured filter is never left out silently.
void require_complete(validator::CheckResult const& result, SourceSet const& sources, Language language) {
  if (result.not_compiled.empty()) return;
  auto const& first = result.not_compiled.front();
  auto const& source = sources[first.place.source];
  throw Failure({.text = Text::cli_not_compiled,
                 .arguments = {{"place", source.name() + ":" +
                                             std::to_string(source.position(first.place.span.begin).line)},
                               {"feature", render(first.feature, language)}}});
}

std::string_view as_text(std::vector<std::byte> const& bytes) {
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

void write_files(CompileWords const& words, std::vector<std::byte> const& image,
                 std::vector<std::string> const& sources) {
  OutputFile output(*words.output);
  output.write(as_text(image));
  if (words.depfile) {
    OutputFile dependencies(*words.depfile);
    dependencies.write(dependency_rule(*words.output, sources));
    dependencies.commit();
  }
  output.commit();
}

std::string findings_text(CompileWords const& words, validator::CheckResult& result, SourceSet const& sources,
                          WriteOptions const& options) {
  auto const format = words.checking.format;
  RunFacts const run{.files = result.files.size(), .fixes = {}, .baseline = {}, .statistics = false};
  number_occurrences(result.findings, sources);
  auto text = document_of(format, result.findings, sources, run, report_context({*words.input}), options);
  if (format == FindingFormat::text && !words.checking.quiet && !result.findings.empty()) {
    text += write_text_summary(run.files, count(result.findings), options);
  }
  return text;
}

std::string summary(CompileWords const& words, validator::Machine const& machine, std::size_t bytes,
                    Language language) {
  std::size_t filters = 0;
  for (auto const& axis : machine.axes) {
    filters += axis.filters.size() + axis.interface_filters.size() + (axis.kernel ? 1 : 0);
    if (axis.position_control) filters += axis.position_control->stages.size();
  }
  return render({.text = Text::cli_compiled,
                 .arguments = {{"file", *words.output},
                               {"axes", std::to_string(machine.axes.size())},
                               {"filters", std::to_string(filters)},
                               {"bytes", std::to_string(bytes)}}},
                language) +
         "\n";
}

/// Schema files decide what a list may say, so a build system has to watch them too.
std::vector<std::string> files_read(validator::CheckResult const& result,
                                    std::optional<Settings> const& settings,
                                    std::vector<std::string> const& schema_files) {
  auto files = result.files;
  if (settings) files.insert(files.end(), settings->schema_files.begin(), settings->schema_files.end());
  files.insert(files.end(), schema_files.begin(), schema_files.end());
  return files;
}

void declare(CommandLine& command_line, CompileWords& words) {
  command_line.argument("INPUT", words.input, Text::cli_arg_input);
  command_line.value("-o,--output", "OUT.axim", words.output, Text::cli_opt_image_output);
  command_line.value("--depfile", "FILE", words.depfile, Text::cli_opt_depfile);
  command_line.flag("--strip", words.strip, Text::cli_opt_strip);
  command_line.value("--image-version", "N", words.image_version, Text::cli_opt_image_version);
  declare_checking(command_line, words.checking);
}

void require_arguments(CompileWords const& words) {
  for (auto const& [given, shown] :
       {std::pair(words.input.has_value(), "INPUT"), {words.output.has_value(), "-o"}}) {
    if (given) continue;
    throw Failure(
        {.text = Text::cli_argument_missing, .arguments = {{"argument", shown}, {"command", "compile"}}});
  }
  if (has_extension(*words.input, ".nc")) {
    throw Failure({.text = Text::cli_nc_program, .arguments = {{"file", *words.input}}});
  }
}

}  // namespace

ExitStatus compile(Invocation const& invocation) {
  CompileWords words;
  CommandLine command_line("compile", Text::cli_compile_purpose, Text::cli_compile_examples,
                           invocation.language);
  declare(command_line, words);
  if (auto const text = command_line.read(invocation.arguments)) {
    invocation.streams.out.write(*text);
    return ExitStatus::success;
  }
  require_arguments(words);
  auto options = check_options(words.checking);
  auto const image = image_options(words);
  static_cast<void>(
      thread_count(words.checking));  // accepted for the sake of scripts; one input needs one thread

  DiskFiles files(words.input == "-");
  SourceSet sources;
  SettingsFinder finder(words.checking.schema_files);
  options.catalogue = finder.catalogue(*words.input);
  auto const settings = finder.find(*words.input);
  if (settings) options = with_settings(std::move(options), *settings, *words.input);
  auto result = validator::check(files, *words.input, options, sources);
  if (result.unreadable) throw unreadable(*words.input, *result.unreadable);
  require_cycle_time(*words.input, result);
  apply_quiet(words.checking, result.findings);
  WriteOptions const write{.language = invocation.language, .color = use_color(command_line.color(), 2)};
  invocation.streams.err.write(findings_text(words, result, sources, write));
  if (!result.machine || objectionable(words.checking, count(result.findings))) return ExitStatus::findings;

  require_complete(result, sources, invocation.language);
  auto const read = files_read(result, settings, words.checking.schema_files);
  refuse_overwriting(*words.output, read);
  auto const bytes = codegen::write_image(*result.machine, image);
  write_files(words, bytes, read);
  if (!words.checking.quiet && words.checking.format == FindingFormat::text) {
    invocation.streams.err.write(summary(words, *result.machine, bytes.size(), invocation.language));
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
