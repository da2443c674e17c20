// What decides about a result, as digests.
#pragma once

#include "cli/checking/check_input.hpp"
#include "cli/fleet/digest.hpp"

#include <span>
#include <string>

namespace axisc::cli {

/// Program, options and form: what decides about the result of an input beside its settings and the files. Relative names
/// in formats of code hosts begin at the repository, so its folder counts in them.
[[nodiscard]] Digest run_digest(CheckJob const& job, ReportFormat const& report_format);

/// The same for one input, with its settings and schema files.
[[nodiscard]] Digest input_digest(Digest const& run, CheckJob const& job, std::string const& path);

/// Adds an input and all files that it leads to, as they are now.
void add_files(Hasher& hasher, CheckJob const& job, std::string const& path);

}  // namespace axisc::cli
