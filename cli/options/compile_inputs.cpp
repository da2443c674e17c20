#include "cli/options/compile_inputs.hpp"

#include "axisc/workspace/image_names.hpp"
#include "cli/options/sentences.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence part_of_machine{
    "{file} is part of {machine}: compile that; an axis list by itself, without the default list and NC "
    "cycle time of its machine, needs --alone",
    "{file} gehört zu {machine}: diese kompilieren; eine Achsliste für sich, ohne Standardliste und "
    "NC-Zykluszeit ihrer Maschine, braucht --alone"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// The image of a list by itself would lack what its machine's other lists configure.
void leave_out_parts(Inputs& inputs, Workspace& workspace) {
  std::vector<std::string> kept;
  auto const belongings = workspace.belonging_of(inputs);
  for (std::size_t i = 0; i < belongings.size(); ++i) {
    auto const& [machine, name] = belongings[i];
    if (machine == inputs.paths[i]) {
      kept.push_back(machine);
    } else {
      inputs.failures.emplace_back(
          Message{says::part_of_machine, {{"file", inputs.paths[i]}, {"machine", machine}}});
    }
  }
  inputs.paths = std::move(kept);
}

void refuse_programs(std::vector<std::string> const& paths) {
  for (auto const& path : paths) {
    if (ascii::has_extension(path, ".nc")) {
      throw Failure({says::nc_program, {{"file", path}}});
    }
  }
}

/// A name from the command line, or the only one in a response file. What kind of file it is shows when it is
/// read.
CompileInputs choose_one(CompileOptions const& options, Workspace& workspace) {
  auto named = options.inputs;
  auto sources = named;
  if (named.front().starts_with('@')) {
    auto inputs = expand_inputs(named);
    if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
    named = std::move(inputs.paths);
    sources = std::move(inputs.sources);
  }
  if (named.size() == 1) named.front() = machine_input(named.front());
  if (named.size() > 1) throw Failure({says::one_output});
  refuse_programs(named);
  CompileInputs chosen;
  chosen.inputs.paths = std::move(named);
  chosen.inputs.sources = std::move(sources);
  if (!options.alone) leave_out_parts(chosen.inputs, workspace);
  if (options.output && !chosen.inputs.paths.empty()) chosen.images = {*options.output};
  return chosen;
}

CompileInputs choose_batch(CompileOptions const& options, Workspace& workspace) {
  auto inputs = expand_inputs(
      options.inputs, [&workspace](std::string const& path) { return workspace.settings().wants(path); });
  // NC programs found in folders are skipped; one that the command line names is a mistake.
  std::erase_if(inputs.paths, [&options](std::string const& path) {
    bool const is_named =
        std::find(options.inputs.begin(), options.inputs.end(), path) != options.inputs.end();
    return ascii::has_extension(path, ".nc") && !is_named;
  });
  refuse_programs(inputs.paths);
  if (!options.alone) leave_out_parts(inputs, workspace);
  auto images = image_names(inputs.paths, options.input_folder.value_or(""), *options.output_folder);
  return {.inputs = std::move(inputs), .images = std::move(images)};
}

}  // namespace

CompileInputs choose_inputs(CompileOptions const& options, Workspace& workspace) {
  return options.is_batch() ? choose_batch(options, workspace) : choose_one(options, workspace);
}

}  // namespace axisc::cli
