// Checks and compiles one input of `axisc compile`.
#pragma once

#include "axisc/checking/check_input.hpp"
#include "axisc/checking/checking_options.hpp"
#include "codegen/image_writer.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace axisc {

struct CompileJob {
  Workspace& workspace;
  CheckingOptions const& checking;
  codegen::ImageOptions image;
  Language language = Language::english;
  codegen::KnownDesigns& designs;  ///< of all inputs of the run
  bool skips_other_lists = false;  ///< instead of refusing them: other files in a folder
};

struct CompiledImage {
  std::string bytes;
  std::size_t axes = 0;
  std::size_t filters = 0;
};

struct CompiledInput {
  CheckedInput checked;  ///< may hold a failure next to findings: what they describe cannot be compiled
  std::optional<CompiledImage> image;
  bool skipped = false;  ///< a list of another kind: it has no image
};

/// May be called by several threads.
[[nodiscard]] CompiledInput compile_input(CompileJob const& job, std::string const& path);

}  // namespace axisc
