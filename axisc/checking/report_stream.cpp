#include "axisc/checking/report_stream.hpp"

#include "axisc/environment/codes.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <utility>

namespace axisc {

namespace {

bool needs_occurrences(ReportPlan const& plan) {
  return has_fingerprints(plan.report_format.format) || plan.baseline || plan.write_baseline;
}

}  // namespace

ReportStream::ReportStream(ReportPlan plan, TextSink out)
    : plan_(std::move(plan)),
      out_(std::move(out)),
      writer_(report_writer(plan_.report_format.format, plan_.report_format.write,
                            std::move(plan_.report_format.context))),
      numbers_(needs_occurrences(plan_)) {
  if (plan_.baseline) missing_ = *plan_.baseline;
  writer_->begin(text_);
  print();
}

void ReportStream::add(CheckedInput const& checked) {
  files_.insert(checked.files.begin(), checked.files.end());
  for (auto const& finding : checked.findings) add(finding, checked.sources);
  writer_->end_input(checked.sources);
}

void ReportStream::add(Finding const& finding, SourceSet const& sources) {
  if (finding.code == cycle_time_assumed && std::exchange(assumption_said_, true)) return;
  std::string name;
  if (numbers_) {
    auto const& identity = identify(finding, sources);
    std::uint32_t const occurrence = ++occurrences_[hash_of(identity)];
    if (is_hidden(identity, occurrence)) return;
    if (has_fingerprints(plan_.report_format.format)) name = fingerprint(identity, occurrence);
  }
  count(finding);
  write(finding, sources, name);
}

Identity const& ReportStream::identify(Finding const& finding, SourceSet const& sources) {
  axisc::identify(identity_, finding, sources);
  if (plan_.identity_paths != nullptr) identity_.file = plan_.identity_paths->of(identity_.file);
  return identity_;
}

void ReportStream::count(Finding const& finding) {
  counts_.add(finding.severity);
  auto const [row, is_new] = codes_.try_emplace(finding.code);
  if (is_new) row->second = {.code = finding.code, .name = finding.name};
  ++row->second.count;
  if (finding.fix) ++row->second.fixable;
}

void ReportStream::write(Finding const& finding, SourceSet const& sources, std::string_view fingerprint) {
  if (finding.code == cycle_time_assumed) {
    writer_->add_notice(text_, finding, sources, fingerprint);
  } else {
    writer_->add(text_, finding, sources, fingerprint);
  }
  print();
}

void ReportStream::print() {
  out_(text_);
  text_.clear();
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

void ReportStream::fail(Failure const& failure) {
  has_failed_ = true;
  writer_->add_failure(failure.sentence(plan_.report_format.write.language));
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
  } else if (!has_failed_) {
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

void ReportStream::finish(std::optional<FixFacts> fixes, std::function<bool(Code)> const& judged) {
  bool const has_numbers = plan_.counts_always || counts_.total() > 0;
  writer_->end(out_, {.files = files_.size(),
                      .fixes = std::move(fixes),
                      .baseline = baseline_facts(judged),
                      .statistics = plan_.statistics,
                      .counts = counts_,
                      .codes = frequent_codes(),
                      .has_summary = !plan_.quiet && !files_.empty() && has_numbers});
}

}  // namespace axisc
