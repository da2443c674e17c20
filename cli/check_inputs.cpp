#include "cli/check_inputs.hpp"

#include "cli/codes.hpp"
#include "cli/finding_report.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

namespace axisc::cli {

namespace {

/// A result and what may only be said once per run.
struct Result {
  Checked checked;
  std::optional<Finding> assumption;  ///< AX9006
};

std::optional<Finding> take_assumption(std::vector<Finding>& findings) {
  auto const found = std::find_if(findings.begin(), findings.end(),
                                  [](Finding const& finding) { return finding.code == cycle_time_assumed; });
  if (found == findings.end()) return std::nullopt;
  std::optional<Finding> assumption = std::move(*found);
  findings.erase(found);
  return assumption;
}

Result check_input(CheckJob const& job, std::string const& path) {
  Result result;
  auto& checked = result.checked;
  EditedFiles files(job.edited, path == "-");
  auto options = options_for(job, path);
  options.machine = false;
  auto outcome = validator::check(files, path, options, checked.sources);
  if (outcome.unreadable) {
    checked.failure = unreadable(path, *outcome.unreadable);
    return result;
  }
  apply_settings_of(job, path, checked.sources, outcome.findings);
  if (job.quiet) {
    std::erase_if(outcome.findings,
                  [](Finding const& finding) { return finding.severity == Severity::note; });
  }
  result.assumption = take_assumption(outcome.findings);
  checked.counts = count(outcome.findings);
  checked.codes = count_codes(outcome.findings);
  checked.files = std::move(outcome.files);
  if (!job.text_at_once) {
    checked.findings = std::move(outcome.findings);
    return result;
  }
  checked.text = texts_of(outcome.findings, checked.sources, job.write);
  checked.sources = {};
  return result;
}

void say_assumption_once(CheckJob const& job, std::vector<Result>& results) {
  auto const first = std::find_if(results.begin(), results.end(),
                                  [](Result const& result) { return result.assumption.has_value(); });
  if (first == results.end()) return;
  auto& checked = first->checked;
  ++checked.counts.notes;
  checked.codes.push_back({.code = first->assumption->code, .name = first->assumption->name, .count = 1});
  if (job.text_at_once) {
    checked.text.insert(0, write_text(*first->assumption, {}, job.write) + "\n");
  } else {
    checked.findings.insert(checked.findings.begin(), *first->assumption);
  }
}

void shift(Place& place, std::size_t by) {
  place.source = static_cast<SourceId>(static_cast<std::size_t>(place.source) + by);
}

}  // namespace

validator::CheckOptions options_for(CheckJob const& job, std::string const& path) {
  if (job.settings == nullptr) return job.options;
  auto options = job.options;
  options.catalogue = job.settings->catalogue(path);
  auto const settings = job.settings->find(path);
  return settings ? with_settings(std::move(options), *settings, path) : options;
}

void apply_settings_of(CheckJob const& job, std::string const& path, SourceSet const& sources,
                       std::vector<Finding>& findings) {
  auto const settings = job.settings == nullptr ? std::nullopt : job.settings->find(path);
  if (settings) apply_settings(*settings, sources, findings);
}

std::vector<Checked> check_inputs(CheckJob const& job, std::vector<std::string> const& paths,
                                  unsigned threads) {
  std::vector<Result> results(paths.size());
  std::vector<std::exception_ptr> errors(paths.size());
  std::atomic<std::size_t> next{0};
  // Each thread takes the next input; an exception ends the program, but only after all threads have stopped.
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
  say_assumption_once(job, results);
  std::vector<Checked> checked;
  checked.reserve(results.size());
  for (auto& result : results) checked.push_back(std::move(result.checked));
  return checked;
}

Collected collect(std::vector<Checked>& results) {
  Collected all;
  for (auto& checked : results) {
    auto const before = all.sources.size();
    if (!checked.findings.empty()) {
      for (std::size_t i = 0; i < checked.sources.size(); ++i) {
        all.sources.add(checked.sources[static_cast<SourceId>(i)]);
      }
    }
    for (auto& finding : checked.findings) {
      if (finding.place) shift(*finding.place, before);
      for (auto& related : finding.related) shift(related.place, before);
      if (finding.fix) {
        for (auto& edit : finding.fix->edits) shift(edit.place, before);
      }
      all.findings.push_back(std::move(finding));
    }
  }
  number_occurrences(all.findings, all.sources);
  return all;
}

}  // namespace axisc::cli
