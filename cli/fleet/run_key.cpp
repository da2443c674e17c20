#include "cli/fleet/run_key.hpp"

#include "cli/fleet/program_digest.hpp"
#include "cli/fleet/recorded_files.hpp"
#include "cli/options/machine_outline.hpp"
#include "validator/loading/loading.hpp"

#include <filesystem>

namespace axisc::cli {

namespace {

void add_options(Hasher& hasher, validator::CheckOptions const& options) {
  hasher.number(options.cycle_time ? options.cycle_time->nanoseconds : 0);
  hasher.number(options.axis_type ? static_cast<std::uint64_t>(*options.axis_type) + 1 : 0);
  hasher.text(options.build ? to_text(*options.build) : "");
  hasher.number(options.pedantic ? 1 : 0);
  hasher.number(options.disabled.size());
  for (auto const code : options.disabled) hasher.number(static_cast<std::uint64_t>(code));
}

void add_report_format(Hasher& hasher, ReportFormat const& report_format) {
  hasher.number(static_cast<std::uint64_t>(report_format.format));
  hasher.number(static_cast<std::uint64_t>(report_format.write.language));
  hasher.number(report_format.write.color ? 1 : 0);
  if (!needs_context(report_format.format)) return;
  hasher.text(report_format.context.paths.root);
  hasher.text(report_format.context.paths.folder);
}

}  // namespace

Digest run_digest(CheckJob const& job, ReportFormat const& report_format) {
  Hasher hasher;
  hasher.digest(program_digest());
  add_options(hasher, job.options);
  hasher.number(job.quiet ? 1 : 0);
  add_report_format(hasher, report_format);
  return hasher.finish();
}

namespace {

/// An input that a folder holds is judged otherwise than one that is named.
void add_found(Hasher& hasher, CheckJob const& job, std::string const& path) {
  auto const found = job.found.find(path);
  if (found == job.found.end()) return hasher.number(0);
  hasher.number(found->second.is_beside_start_up_list ? 2 : 1);
}

}  // namespace

Digest input_digest(Digest const& run, CheckJob const& job, std::string const& path) {
  Hasher hasher;
  hasher.digest(run);
  add_found(hasher, job, path);
  hasher.digest(job.settings->digest(path));
  return hasher.finish();
}

void add_files(Hasher& hasher, CheckJob const& job, std::string const& path) {
  hasher.text(path);
  add_found(hasher, job, path);
  hasher.digest(job.settings->digest(path));
  RecordedFiles files(nullptr);
  if (has_extension(path, ".json")) {
    SourceSet sources;
    static_cast<void>(validator::load(files, path, options_for(job, path), sources));
  } else {
    auto const state = files.state_of(path);
    hasher.digest(state.digest);
    hasher.number(state.error ? 1 : 0);
  }
  for (auto const& [name, state] : files.dependencies()) {
    hasher.text(name);
    hasher.digest(state.digest);
    hasher.number(state.error ? 1 : 0);
  }
}

}  // namespace axisc::cli
