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
constexpr Sentence option_export_kind{"what to make: c, sources in C99",
                                      "was entstehen soll: c, Quelltexte in C99"};
constexpr Sentence option_export_folder{
    "folder to write into; it is made if it does not exist",
    "Ordner, in den geschrieben wird; er wird angelegt, wenn es ihn nicht gibt"};
constexpr Sentence option_complete{"keep names, self-tests, lists and NC programs in the image",
                                   "Namen, Selbsttests, Listen und NC-Programme im Abbild behalten"};
constexpr Sentence exported{"{folder}: {files} written, axes: {axes}, {bytes} bytes",
                            "{folder}: {files} geschrieben, Achsen: {axes}, {bytes} Bytes"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class ExportKind : std::uint8_t { none, c };

struct ExportOptions {
  MachineRequest request;
  std::optional<std::string> input, folder, cycle_time;
  ExportKind kind = ExportKind::none;
  image::CSourcesOptions sources;
};

void declare(CommandLine& command_line, ExportOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_exported);
  command_line.choice("--to", {{"c", ExportKind::c}}, options.kind, says::option_export_kind);
  command_line.value("-o,--output", "FOLDER", options.folder, says::option_export_folder);
  command_line.flag("--complete", options.sources.complete, says::option_complete);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.request.alone);
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

}  // namespace

ExitStatus export_filters(Invocation const& invocation) {
  ExportOptions options;
  CommandLine command_line("export", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.require(options.kind != ExportKind::none, "--to");
  command_line.require(options.folder.has_value(), "-o FOLDER");
  options.request.input = *options.input;
  Workspace workspace(overrides_with(options.cycle_time));
  auto const exported =
      exported_image(workspace, options.request,
                     printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!exported) return ExitStatus::findings;
  auto const files = image::c_sources(exported->file.bytes.bytes(), exported->file.contents, options.sources);
  write_files(*options.folder, files, exported->sources);
  invocation.streams.err.write(summary(*options.folder, files, exported->file, invocation.language));
  return ExitStatus::success;
}

}  // namespace axisc::cli
