#include "cli/checking.hpp"
#include "cli/codes.hpp"
#include "cli/commands.hpp"
#include "cli/disk_files.hpp"
#include "cli/inputs.hpp"
#include "diagnostics/writers.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <set>
#include <thread>

namespace axisc::cli {

namespace {

/// One input, checked; everything that the output in input order needs.
struct Checked {
  std::vector<Finding> findings;  ///< only for JSON
  SourceSet sources;              ///< only for JSON
  std::string text;
  FindingCounts counts;
  std::vector<std::string> files;
  std::optional<Failure> failure;
  std::optional<Finding> assumption;  ///< AX9006, which is said once per run
};

struct Job {
  CheckingWords words;
  validator::CheckOptions options;
  WriteOptions write;
};

std::optional<Finding> take_assumption(std::vector<Finding>& findings) {
  auto const found = std::find_if(findings.begin(), findings.end(),
                                  [](Finding const& finding) { return finding.code == cycle_time_assumed; });
  if (found == findings.end()) return std::nullopt;
  std::optional<Finding> assumption = std::move(*found);
  findings.erase(found);
  return assumption;
}

Checked check_input(Job const& job, std::string const& path) {
  Checked checked;
  DiskFiles files(path == "-");
  auto result = validator::check(files, path, job.options, checked.sources);
  if (result.unreadable) {
    checked.failure = unreadable(path, *result.unreadable);
    return checked;
  }
  apply_quiet(job.words, result.findings);
  checked.assumption = take_assumption(result.findings);
  checked.counts = count(result.findings);
  checked.files = std::move(result.files);
  if (job.words.format == FindingFormat::json) {
    checked.findings = std::move(result.findings);
    return checked;
  }
  for (auto const& finding : result.findings) {
    checked.text += write_text(finding, checked.sources, job.write) + "\n";
  }
  checked.sources = {};
  return checked;
}

/// Each thread takes the next input; an exception ends the program, but only after all threads have stopped.
std::vector<Checked> check_all(Job const& job, std::vector<std::string> const& paths, unsigned threads) {
  std::vector<Checked> results(paths.size());
  std::vector<std::exception_ptr> errors(paths.size());
  std::atomic<std::size_t> next{0};
  auto const work = [&] {
    for (std::size_t i = next++; i < paths.size(); i = next++) {
      try {
        results[i] = check_input(job, paths[i]);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> helpers;
  auto const wanted = std::min<std::size_t>(threads, paths.size());
  for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(work);
  work();
  for (auto& helper : helpers) helper.join();
  for (auto const& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  return results;
}

void shift(Place& place, std::size_t by) {
  place.source = static_cast<SourceId>(static_cast<std::size_t>(place.source) + by);
}

/// Moves the findings of one input into the collection of all.
void collect(Checked& checked, std::vector<Finding>& findings, SourceSet& sources) {
  auto const before = sources.size();
  if (!checked.findings.empty()) {
    for (std::size_t i = 0; i < checked.sources.size(); ++i) {
      sources.add(checked.sources[static_cast<SourceId>(i)]);
    }
  }
  for (auto& finding : checked.findings) {
    if (finding.place) shift(*finding.place, before);
    for (auto& related : finding.related) shift(related.place, before);
    if (finding.fix) {
      for (auto& edit : finding.fix->edits) shift(edit.place, before);
    }
    findings.push_back(std::move(finding));
  }
}

struct Total {
  FindingCounts counts;
  std::size_t files = 0;
};

Total sum_up(std::vector<Checked> const& results) {
  Total total;
  std::set<std::string> files;
  for (auto const& checked : results) {
    total.counts.errors += checked.counts.errors;
    total.counts.warnings += checked.counts.warnings;
    total.counts.notes += checked.counts.notes;
    files.insert(checked.files.begin(), checked.files.end());
  }
  total.files = files.size();
  return total;
}

/// Keeps the first assumption of the run, as the first finding of its input.
void say_assumption_once(Job const& job, std::vector<Checked>& results) {
  auto const first = std::find_if(results.begin(), results.end(),
                                  [](Checked const& checked) { return checked.assumption.has_value(); });
  if (first == results.end()) return;
  ++first->counts.notes;
  if (job.words.format == FindingFormat::text) {
    first->text.insert(0, write_text(*first->assumption, {}, job.write) + "\n");
  } else {
    first->findings.insert(first->findings.begin(), *first->assumption);
  }
}

std::string output(Job const& job, std::vector<Checked>& results, Total const& total) {
  if (job.words.format == FindingFormat::json) {
    std::vector<Finding> findings;
    SourceSet sources;
    for (auto& checked : results) collect(checked, findings, sources);
    return write_json(findings, sources, total.files, job.write);
  }
  std::string text;
  for (auto const& checked : results) text += checked.text;
  if (!job.words.quiet && total.files > 0) text += write_text_summary(total.files, total.counts, job.write);
  return text;
}

}  // namespace

ExitStatus lint(Invocation const& invocation) {
  Job job;
  std::vector<std::string> named;
  CommandLine command_line("lint", Text::cli_lint_purpose, Text::cli_lint_examples, invocation.language);
  command_line.arguments("INPUT...", named, Text::cli_arg_inputs);
  declare_checking(command_line, job.words);
  if (auto const text = command_line.read(invocation.arguments)) {
    invocation.streams.out.write(*text);
    return ExitStatus::success;
  }
  if (named.empty()) {
    throw Failure(
        {.text = Text::cli_argument_missing, .arguments = {{"argument", "INPUT"}, {"command", "lint"}}});
  }
  job.options = check_options(job.words);
  job.write = {.language = invocation.language, .color = use_color(command_line.color(), 1)};
  auto const threads = thread_count(job.words);

  auto inputs = expand_inputs(named);
  auto results = check_all(job, inputs.paths, threads);
  for (auto const& checked : results) {
    if (checked.failure) inputs.failures.push_back(*checked.failure);
  }
  for (auto const& failure : inputs.failures) invocation.streams.err.write(failure.line(invocation.language));
  say_assumption_once(job, results);
  auto const total = sum_up(results);
  invocation.streams.out.write(output(job, results, total));
  if (!inputs.failures.empty()) return ExitStatus::failure;
  return objectionable(job.words, total.counts) ? ExitStatus::findings : ExitStatus::success;
}

}  // namespace axisc::cli
