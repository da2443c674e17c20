#include "cli/report/report_stream.hpp"

#include "cli/codes.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

bool needs_occurrences(ReportPlan const& plan) {
  auto const format = plan.report_format.format;
  return format == FindingFormat::sarif || format == FindingFormat::gitlab || plan.baseline ||
         plan.write_baseline;
}

std::string_view name_of(Code code) {
  auto const* const rule = validator::find_rule(code);
  return rule == nullptr ? std::string_view{} : rule->name;
}

}  // namespace

ReportStream::ReportStream(ReportPlan plan, Console& out)
    : plan_(std::move(plan)), out_(out), numbers_(needs_occurrences(plan_)) {
  if (plan_.baseline) missing_ = *plan_.baseline;
  if (plan_.report_format.format == FindingFormat::json) out_.write(json_head());
  if (plan_.report_format.format == FindingFormat::gitlab) out_.write("[");
}

void ReportStream::add(std::size_t number, CheckedInput const& checked) {
  files_.insert(checked.files.begin(), checked.files.end());
  for (auto const& finding : checked.findings) add(finding);
  std::vector<std::size_t> artifacts;
  artifacts.reserve(used_.size());
  for (auto const index : used_) artifacts.push_back(number_of(checked.artifacts[index]));
  used_.clear();
  auto const shown = std::exchange(shown_, 0);
  if (!plan_.shard || shown == 0) return;
  plan_.shard->inputs.push_back({.number = number, .findings = shown, .artifacts = std::move(artifacts)});
}

void ReportStream::add(WrittenFinding const& finding) {
  if (finding.identity.code == cycle_time_assumed && std::exchange(assumption_said_, true)) return;
  auto const& identity = identify(finding);
  std::uint32_t const occurrence = numbers_ ? ++occurrences_[digest_of(fingerprint(identity, 0)).low] : 1;
  if (is_hidden(identity, occurrence)) return;
  count(finding);
  print(finding, identity, occurrence);
  ++shown_;
  used_.insert(finding.artifacts.begin(), finding.artifacts.end());
}

Identity const& ReportStream::identify(WrittenFinding const& finding) {
  if (plan_.identity_paths == nullptr || (!numbers_ && !plan_.shard)) return finding.identity;
  identity_ = finding.identity;
  auto const& path = plan_.identity_paths->of(identity_.file);
  if (plan_.shard && !identity_.file.empty()) {
    bool const in_repository = plan_.report_format.format == FindingFormat::sarif;
    auto const& paths = plan_.report_format.context.paths;
    auto const shown = in_repository ? shown_path(paths, identity_.file) : identity_.file;
    if (shown != path) plan_.shard->identity_paths[shown] = path;
  }
  identity_.file = path;
  return identity_;
}

std::size_t ReportStream::number_of(Artifact const& artifact) {
  // Different machines may name the same list by different paths.
  auto const path = shown_path(plan_.report_format.context.paths, artifact.name);
  auto const [number, is_new] = artifact_numbers_.try_emplace(path, artifacts_.size());
  if (is_new) artifacts_.push_back(artifact);
  return number->second;
}

void ReportStream::count(WrittenFinding const& finding) {
  counts_.add(finding.severity);
  auto const code = finding.identity.code;
  auto const [row, is_new] = codes_.try_emplace(code);
  if (is_new) row->second = {.code = code, .name = name_of(code)};
  ++row->second.count;
  if (finding.fixable) ++row->second.fixable;
}

bool ReportStream::is_hidden(Identity const& identity, std::uint32_t occurrence) {
  if (plan_.write_baseline) {
    found_.add(identity, occurrence);
    if (!found_.holds(identity, occurrence)) return false;
  } else {
    if (!plan_.baseline) return false;
    if (plan_.baseline->holds(identity, occurrence)) {
      missing_.remove(identity, occurrence);
    } else if (!was_elsewhere(identity, occurrence)) {
      return false;
    }
  }
  ++hidden_;
  return true;
}

bool ReportStream::was_elsewhere(Identity const& identity, std::uint32_t occurrence) {
  if (plan_.identity_paths == nullptr) return false;
  auto const anywhere = [](Identity entry, std::uint32_t number) {
    entry.file.clear();
    return BaselineEntry{.identity = std::move(entry), .occurrence = number};
  };
  if (!gone_) {
    gone_.emplace();
    for (auto const& entry : missing_.entries()) {
      if (!plan_.identity_paths->is_gone(entry.identity.file)) continue;
      gone_->emplace(anywhere(entry.identity, entry.occurrence), entry.identity.file);
    }
  }
  auto const found = gone_->find(anywhere(identity, occurrence));
  if (found == gone_->end() || plan_.identity_paths->is_gone(identity.file)) return false;
  auto gone = identity;
  gone.file = found->second;
  missing_.remove(gone, occurrence);
  gone_->erase(found);
  return true;
}

void ReportStream::print(WrittenFinding const& finding, Identity const& identity, std::uint32_t occurrence) {
  auto const format = plan_.report_format.format;
  // A shard keeps it among its findings, for the run that combines them.
  if (format == FindingFormat::sarif && identity.code == cycle_time_assumed && !plan_.shard) {
    auto const result = nlohmann::json::parse(fill_holes(finding.text, {}));
    plan_.report_format.context.notices.push_back({.code = identity.code,
                                                   .severity = finding.severity,
                                                   .sentence = result["message"]["text"].get<std::string>()});
    return;
  }
  bool const has_elements = std::exchange(has_elements_, true);
  if (format == FindingFormat::sarif) {
    // Rule indices stay as holes: which rules are listed is known only at the end.
    std::string filled = finding.text;
    auto const text = fingerprint(identity, occurrence);
    for (auto at = filled.find(fingerprint_hole); at != std::string::npos;
         at = filled.find(fingerprint_hole)) {
      filled.replace(at, 1, text);
    }
    sarif_results_.add(static_cast<std::uint64_t>(finding.identity.code), filled);
    return;
  }
  bool const is_list = format == FindingFormat::json || format == FindingFormat::gitlab;
  if (is_list && has_elements) out_.write(",");
  if (format == FindingFormat::gitlab) {
    out_.write(fill_holes(finding.text, {.fingerprint = fingerprint(identity, occurrence)}));
  } else {
    out_.write(finding.text);
  }
}

void ReportStream::fail(std::size_t order, Failure const& failure) {
  auto const language = plan_.report_format.write.language;
  plan_.report_format.context.failures.push_back(failure.sentence(language));
  if (!plan_.shard) return;
  plan_.shard->failures.push_back(
      {.order = order, .line = failure.line(language), .sentence = failure.sentence(language)});
}

std::vector<CodeCount> ReportStream::frequent_codes() const {
  std::vector<CodeCount> rows;
  rows.reserve(codes_.size());
  for (auto const& [code, row] : codes_) rows.push_back(row);
  most_frequent_first(rows);
  return rows;
}

std::optional<BaselineFacts> ReportStream::baseline_facts(std::function<bool(Code)> const& judged) const {
  if (!plan_.baseline && !plan_.write_baseline) return std::nullopt;
  BaselineFacts facts{.hidden = hidden_, .stale = {}};
  if (plan_.write_baseline) {
    facts.recorded = found_.size();
  } else if (plan_.report_format.context.failures.empty()) {
    std::set<std::string> files;
    if (plan_.identity_paths != nullptr) {
      for (auto const& file : files_) files.insert(plan_.identity_paths->of(file));
    }
    facts.stale = missing_.identities();
    std::erase_if(facts.stale, [&](Identity const& identity) {
      bool const was_checked = plan_.identity_paths == nullptr || files.contains(identity.file) ||
                               plan_.identity_paths->is_gone(identity.file);
      return !was_checked || !judged(identity.code);
    });
  }
  return facts;
}

void ReportStream::print_sarif() {
  auto const& report_format = plan_.report_format;
  std::set<Code> codes;
  for (auto const& [code, row] : codes_) codes.insert(code);
  out_.write(sarif_head(codes, artifacts_, report_format.context, report_format.write.language));
  bool first = true;
  sarif_results_.replay([&](std::uint64_t code, std::string_view element) {
    if (!std::exchange(first, false)) out_.write(",");
    auto const index = rule_index(codes, static_cast<Code>(code), report_format.context);
    out_.write(fill_holes(element, {.rule_index = index}));
  });
}

void ReportStream::finish(std::optional<FixFacts> fixes, std::function<bool(Code)> const& judged,
                          int status) {
  RunFacts const run{.files = files_.size(),
                     .fixes = std::move(fixes),
                     .baseline = baseline_facts(judged),
                     .statistics = plan_.statistics};
  std::string shard;
  if (plan_.shard) {
    plan_.shard->status = status;
    plan_.shard->files.assign(files_.begin(), files_.end());
    std::sort(plan_.shard->files.begin(), plan_.shard->files.end());
    shard = as_json(*plan_.shard);
  }
  auto const rows = frequent_codes();
  switch (plan_.report_format.format) {
    case FindingFormat::text:
      if (run.statistics && !rows.empty()) {
        out_.write(write_text_statistics(rows, plan_.report_format.write) + "\n");
      }
      if (!plan_.quiet && run.files > 0 && (plan_.counts_always || has_elements_)) {
        out_.write(write_text_facts(run, plan_.report_format.write) +
                   write_text_summary(run.files, counts_, plan_.report_format.write));
      }
      break;
    case FindingFormat::json:
      out_.write(json_tail(has_elements_, run, counts_, rows, shard));
      break;
    case FindingFormat::sarif:
      print_sarif();
      out_.write(sarif_tail(has_elements_, shard));
      break;
    case FindingFormat::gitlab:
      out_.write(has_elements_ ? "\n]\n" : "]\n");
      break;
    case FindingFormat::github:
      break;
  }
}

}  // namespace axisc::cli
