#include "cli/options/compile_inputs.hpp"

#include "axisc/workspace/image_names.hpp"
#include "cli/options/sentences.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli {

namespace {

void refuse_programs(std::vector<std::string> const& paths) {
  for (auto const& path : paths) {
    if (ascii::has_extension(path, ".nc")) {
      throw Failure({says::nc_program, {{"file", path}}});
    }
  }
}

/// A name from the command line, or the only one in a response file. What kind of file it is shows when it is
/// read.
CompileInputs choose_one(CompileOptions const& options) {
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
  if (options.output) chosen.images = {*options.output};
  return chosen;
}

CompileInputs choose_batch(CompileOptions const& options, SettingsFinder& settings) {
  auto inputs =
      expand_inputs(options.inputs, [&settings](std::string const& path) { return settings.wants(path); });
  // NC programs found in folders are skipped; one that the command line names is a mistake.
  std::erase_if(inputs.paths, [&options](std::string const& path) {
    bool const is_named =
        std::find(options.inputs.begin(), options.inputs.end(), path) != options.inputs.end();
    return ascii::has_extension(path, ".nc") && !is_named;
  });
  refuse_programs(inputs.paths);
  auto images = image_names(inputs.paths, options.input_folder.value_or(""), *options.output_folder);
  return {.inputs = std::move(inputs), .images = std::move(images)};
}

}  // namespace

CompileInputs choose_inputs(CompileOptions const& options, SettingsFinder& settings) {
  return options.is_batch() ? choose_batch(options, settings) : choose_one(options);
}

}  // namespace axisc::cli
