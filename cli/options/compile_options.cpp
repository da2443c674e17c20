#include "cli/options/compile_options.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "cli/options/sentences.hpp"

#include <limits>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence bad_image_version{
    "--image-version needs a whole number from 0 to 4294967295, not \"{value}\"",
    "--image-version braucht eine ganze Zahl von 0 bis 4294967295, nicht \"{value}\""};
constexpr Sentence option_image_output{
    "the image to write, or - for standard output; an image that would not change is left untouched",
    "das zu schreibende Abbild, oder - für die Standardausgabe; ein Abbild, das sich nicht ändern würde, "
    "bleibt unberührt"};
constexpr Sentence option_depfile{
    "write the files that were read as a rule for make and ninja, one rule per image",
    "die gelesenen Dateien als Regel für make und ninja schreiben, eine Regel je Abbild"};
constexpr Sentence option_strip{"leave out names, sources and self-tests, for small memories",
                                "Namen, Quellen und Selbsttests weglassen, für kleine Speicher"};
constexpr Sentence option_no_bounds{
    "leave out the proved bounds that `axisc certify` checks and the runtime supervises with",
    "die bewiesenen Schranken weglassen, die `axisc certify` prüft und mit denen das Laufzeitsystem "
    "überwacht"};
constexpr Sentence option_image_version{
    "version counter of the machine builder, stored in the image (default: 0)",
    "Versionszähler des Maschinenherstellers, im Abbild gespeichert (Standardwert: 0)"};

constexpr Sentence option_output_folder{
    "write one image per input below this folder, named like the input, with .axim at the end",
    "je Eingabe ein Abbild unter diesem Ordner schreiben, benannt wie die Eingabe, mit .axim am Ende"};
constexpr Sentence option_input_folder{
    "with --output-folder: image names are relative to this folder (default: the working folder)",
    "mit --output-folder: die Namen der Abbilder sind relativ zu diesem Ordner (Standardwert: der "
    "Arbeitsordner)"};
constexpr Sentence two_outputs{"-o and --output-folder cannot be used together",
                               "-o und --output-folder gehen nicht zusammen"};
constexpr Sentence input_folder_alone{"--input-folder needs --output-folder",
                                      "--input-folder geht nur mit --output-folder"};
constexpr Sentence argument_compile_inputs{
    "axis lists, machine files (*.json), folders with any of them, @FILE with one name per line, or - for "
    "standard input",
    "Achslisten, Maschinendateien (*.json), Ordner mit solchen, @DATEI mit einem Namen je Zeile, oder - für "
    "die Standardeingabe"};
constexpr Sentence option_compile_alone{
    "compile a list by itself although a machine names it, without that machine's default list",
    "eine Liste für sich kompilieren, obwohl eine Maschine sie nennt, ohne deren Standardliste"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare(CommandLine& command_line, CompileOptions& options) {
  command_line.arguments("INPUT...", options.inputs, says::argument_compile_inputs);
  command_line.value("-o,--output", "OUT.axim", options.output, says::option_image_output);
  command_line.value("--output-folder", "FOLDER", options.output_folder, says::option_output_folder);
  command_line.value("--input-folder", "FOLDER", options.input_folder, says::option_input_folder);
  command_line.value("--depfile", "FILE", options.depfile, says::option_depfile);
  command_line.flag("--strip", options.strip, says::option_strip);
  command_line.flag("--no-bounds", options.no_bounds, says::option_no_bounds);
  command_line.value("--image-version", "N", options.image_version, says::option_image_version);
  command_line.flag("--alone", options.alone, says::option_compile_alone);
  declare_checking(command_line, options.checking);
}

void require_sense(CommandLine const& command_line, CompileOptions const& options) {
  command_line.require(!options.inputs.empty(), "INPUT");
  if (options.output && options.output_folder) {
    throw Failure({says::two_outputs});
  }
  if (options.is_batch()) return;
  if (options.input_folder) throw Failure({says::input_folder_alone});
  if (options.inputs.size() > 1) throw Failure({says::one_output});
  command_line.require(options.output.has_value(), "-o");
}

codegen::ImageOptions image_options(CompileOptions const& given) {
  codegen::ImageOptions options;
  options.strip = given.strip;
  options.bounds = !given.no_bounds;
  if (!given.image_version) return options;
  auto const version = parse_count(*given.image_version);
  if (!version || *version > std::numeric_limits<std::uint32_t>::max()) {
    throw Failure({says::bad_image_version, {{"value", *given.image_version}}});
  }
  options.image_version = static_cast<std::uint32_t>(*version);
  return options;
}

}  // namespace axisc::cli
