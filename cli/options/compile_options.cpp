#include "cli/options/compile_options.hpp"

#include "cli/failure.hpp"
#include "cli/options/quantities.hpp"

#include <limits>
#include <utility>

namespace axisc::cli {

void declare(CommandLine& command_line, CompileWords& words) {
  command_line.arguments("INPUT...", words.inputs, Text::cli_arg_compile_inputs);
  command_line.value("-o,--output", "OUT.axim", words.output, Text::cli_opt_image_output);
  command_line.value("--output-folder", "FOLDER", words.output_folder, Text::cli_opt_output_folder);
  command_line.value("--input-folder", "FOLDER", words.input_folder, Text::cli_opt_input_folder);
  command_line.value("--depfile", "FILE", words.depfile, Text::cli_opt_depfile);
  command_line.flag("--strip", words.strip, Text::cli_opt_strip);
  command_line.value("--image-version", "N", words.image_version, Text::cli_opt_image_version);
  declare_checking(command_line, words.checking);
  declare_fleet(command_line, words.fleet);
}

void require_sense(CommandLine const& command_line, CompileWords const& words) {
  command_line.require(!words.inputs.empty(), "INPUT");
  if (words.output && words.output_folder) throw Failure({.text = Text::cli_two_outputs, .arguments = {}});
  if (words.is_batch()) return;
  for (auto const& [given, option] : {std::pair(words.input_folder.has_value(), "--input-folder"),
                                      {words.fleet.shard.has_value(), "--shard"}}) {
    if (given) throw Failure({.text = Text::cli_needs_output_folder, .arguments = {{"option", option}}});
  }
  if (words.inputs.size() > 1) throw Failure({.text = Text::cli_one_output, .arguments = {}});
  command_line.require(words.output || words.fleet.print_key, "-o");
}

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

}  // namespace axisc::cli
