// Cache keys: digests of everything a result depends on.
#pragma once

#include "cli/checking/check_input.hpp"
#include "cli/fleet/digest.hpp"

#include <span>
#include <string>

namespace axisc::cli {

/// Program, options and report format: everything that the result of an input depends on besides its settings and the
/// files. In formats of code hosts, names are relative to the repository, so its folder is included.
[[nodiscard]] Digest run_digest(CheckJob const& job, ReportFormat const& report_format);

/// The run's digest with the settings and schema files of one input.
[[nodiscard]] Digest input_digest(Digest const& run, CheckJob const& job, std::string const& path);

/// Adds the present content of an input and of all files that it refers to.
void add_files(Hasher& hasher, CheckJob const& job, std::string const& path);

}  // namespace axisc::cli
