#include "axisc/exporting/exported_fmu.hpp"
#include "axisc/exporting/exported_image.hpp"
#include "axisc/exporting/written_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_exported{
    "an image, a list, a machine file, a start-up list, a project, or a folder with one machine",
    "ein Abbild, eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt oder ein Ordner mit einer "
    "Maschine"};
constexpr Sentence option_export_kind{
    "what to make: c, a folder of sources in C99; fmu3, fmu2, an FMU for co-simulation",
    "was entstehen soll: c, ein Ordner mit Quelltexten in C99; fmu3, fmu2, eine FMU für Co-Simulation"};
constexpr Sentence option_export_output{
    "the FMU, or the folder of sources; it is made if it does not exist",
    "die FMU, oder der Ordner der Quelltexte; er wird angelegt, wenn es ihn nicht gibt"};
constexpr Sentence option_binaries{
    "libraries in the FMU: linux64, win64 or linux64,win64; none; or auto, for which compilers are "
    "installed (default)",
    "Bibliotheken in der FMU: linux64, win64 oder linux64,win64; none; oder auto, wofür Compiler da "
    "sind (Standardwert)"};
constexpr Sentence option_plain_integers{
    "integers instead of booleans and enumerations in the FMU, for importers that lack these",
    "ganze Zahlen statt Booleans und Enumerations in der FMU, für Importeure, denen diese fehlen"};
constexpr Sentence option_complete{"keep names, self-tests, lists and NC programs in the image",
                                   "Namen, Selbsttests, Listen und NC-Programme im Abbild behalten"};
constexpr Sentence only_for_fmu{"{option} is for --to fmu3 and --to fmu2 alone",
                                "{option} gibt es nur mit --to fmu3 und --to fmu2"};
constexpr Sentence libraries_none{"none", "keine"};
constexpr Sentence exported_fmu{
    "{file}: written, axes: {axes}, libraries: {libraries}, {bytes} bytes",
    "{file}: geschrieben, Achsen: {axes}, Bibliotheken: {libraries}, {bytes} Bytes"};
constexpr Sentence exported{"{folder}: {files} written, axes: {axes}, {bytes} bytes",
                            "{folder}: {files} geschrieben, Achsen: {axes}, {bytes} Bytes"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class ExportKind : std::uint8_t { none, c, fmu3, fmu2 };

struct ExportOptions {
  MachineRequest request;
  std::optional<std::string> input, output, cycle_time, binaries;
  std::vector<image::FmuPlatform> platforms;  ///< by `binaries`
  ExportKind kind = ExportKind::none;
  bool complete = false;
  bool plain_integers = false;
};

void declare(CommandLine& command_line, ExportOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_exported);
  command_line.choice("--to", {{"c", ExportKind::c}, {"fmu3", ExportKind::fmu3}, {"fmu2", ExportKind::fmu2}},
                      options.kind, says::option_export_kind);
  command_line.value("-o,--output", "OUT", options.output, says::option_export_output);
  command_line.flag("--complete", options.complete, says::option_complete);
  command_line.value("--binaries", "linux64,win64|none|auto", options.binaries, says::option_binaries);
  command_line.flag("--plain-integers", options.plain_integers, says::option_plain_integers);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.request.alone);
}

/// Nothing that is asked for is ignored.
void require_usable(ExportOptions& options) {
  if (options.kind != ExportKind::c) {
    options.platforms = library_platforms(options.binaries.value_or("auto"));
    return;
  }
  if (options.binaries) throw Failure({says::only_for_fmu, {{"option", "--binaries"}}});
  if (options.plain_integers) throw Failure({says::only_for_fmu, {{"option", "--plain-integers"}}});
}

std::string summary(std::string const& folder, std::vector<image::ExportedFile> const& files,
                    ImageFile const& image, Language language) {
  std::string names;
  std::size_t bytes = 0;
  for (auto const& file : files) {
    names += (names.empty() ? "" : ", ") + file.name;
    bytes += file.content.size();
  }
  return render({says::exported,
                 {{"folder", folder},
                  {"files", names},
                  {"axes", std::to_string(image.contents.axes.size())},
                  {"bytes", std::to_string(bytes)}}},
                language) +
         "\n";
}

void export_sources(ExportOptions const& options, ExportedImage const& exported,
                    Invocation const& invocation) {
  auto const files =
      image::c_sources(exported.file.bytes.bytes(), exported.file.contents, {.complete = options.complete});
  write_files(*options.output, files, exported.sources);
  invocation.streams.err.write(summary(*options.output, files, exported.file, invocation.language));
}

void export_fmu(ExportOptions const& options, ExportedImage const& exported, Invocation const& invocation) {
  auto const fmu = exported_fmu(
      exported.file,
      {.version = options.kind == ExportKind::fmu3 ? image::FmiVersion::three : image::FmiVersion::two,
       .name = model_name(*options.output),
       .complete = options.complete,
       .plain_integers = options.plain_integers},
      options.platforms);
  write_file(*options.output, fmu.archive, exported.sources);
  auto const language = invocation.language;
  for (auto const& missing : fmu.missing) invocation.streams.err.write(render(missing, language) + "\n");
  std::string names;
  for (auto const& library : fmu.libraries) names += (names.empty() ? "" : ", ") + library;
  invocation.streams.err.write(
      render({says::exported_fmu,
              {{"file", *options.output},
               {"axes", std::to_string(exported.file.contents.axes.size())},
               {"libraries", names.empty() ? render({says::libraries_none}, language) : names},
               {"bytes", std::to_string(fmu.archive.size())}}},
             language) +
      "\n");
}

}  // namespace

ExitStatus export_filters(Invocation const& invocation) {
  ExportOptions options;
  CommandLine command_line("export", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.require(options.kind != ExportKind::none, "--to");
  command_line.require(options.output.has_value(), "-o OUT");
  require_usable(options);
  options.request.input = *options.input;
  Workspace workspace(overrides_with(options.cycle_time));
  auto const exported =
      exported_image(workspace, options.request,
                     printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!exported) return ExitStatus::findings;
  if (options.kind == ExportKind::c) {
    export_sources(options, *exported, invocation);
  } else {
    export_fmu(options, *exported, invocation);
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
