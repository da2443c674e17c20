// The command line of `axisc compile`.
#pragma once

#include "cli/options/check_options.hpp"
#include "codegen/image_writer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct CompileOptions {
  CheckingOptions checking;
  std::vector<std::string> inputs;
  std::optional<std::string> output;
  std::optional<std::string> output_folder;
  std::optional<std::string> input_folder;
  std::optional<std::string> depfile;
  std::optional<std::string> image_version;
  bool alone = false;
  bool strip = false;
  bool no_bounds = false;

  [[nodiscard]] bool is_batch() const { return output_folder.has_value(); }
};

void declare(CommandLine& command_line, CompileOptions& options);
/// Failure for options that exclude each other.
void require_sense(CommandLine const& command_line, CompileOptions const& options);
/// Failure for an invalid value.
[[nodiscard]] codegen::ImageOptions image_options(CompileOptions const& given);

}  // namespace axisc::cli
