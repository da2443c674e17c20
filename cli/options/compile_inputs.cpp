#include "cli/options/compile_inputs.hpp"

#include "cli/options/image_names.hpp"
#include "cli/options/machine_outline.hpp"
#include "cli/options/sentences.hpp"
#include "cli/sentences.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli {

namespace {

void refuse_programs(std::vector<std::string> const& paths) {
  for (auto const& path : paths) {
    if (has_extension(path, ".nc")) {
      throw Failure({.sentence = says::nc_program, .arguments = {{"file", path}}});
    }
  }
}

/// A name of the command line, or the only one of a response file. Whatever else it is shows when it is read.
CompileInputs choose_one(CompileWords const& words) {
  auto named = words.inputs;
  if (named.front().starts_with('@')) {
    auto inputs = expand_inputs(named);
    if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
    named = std::move(inputs.paths);
  }
  if (named.size() > 1) throw Failure({.sentence = says::one_output, .arguments = {}});
  refuse_programs(named);
  CompileInputs chosen{.part = choose_part({}, std::move(named)), .images = {}, .failures = {}};
  if (words.output) chosen.images = {*words.output};
  return chosen;
}

CompileInputs choose_batch(CompileWords const& words) {
  auto inputs = expand_inputs(words.inputs);
  // In folders NC programs lie beside lists; named by hand they are a misunderstanding.
  std::erase_if(inputs.paths, [&words](std::string const& path) {
    bool const is_named = std::find(words.inputs.begin(), words.inputs.end(), path) != words.inputs.end();
    return has_extension(path, ".nc") && !is_named;
  });
  refuse_programs(inputs.paths);
  auto images = image_names(inputs.paths, words.input_folder.value_or(""), *words.output_folder);
  return {.part = choose_part(words.fleet, std::move(inputs.paths)),
          .images = std::move(images),
          .failures = std::move(inputs.failures)};
}

}  // namespace

CompileInputs choose_inputs(CompileWords const& words) {
  return words.is_batch() ? choose_batch(words) : choose_one(words);
}

}  // namespace axisc::cli
