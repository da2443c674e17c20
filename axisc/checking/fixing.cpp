#include "axisc/checking/fixing.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/fix_batch.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <variant>

namespace axisc {

namespace {

/// Trials in one round; thousands of fixes of which none can be applied would otherwise take hours.
constexpr std::size_t most_checks = 200;

using Counts = std::map<Identity, std::size_t>;
using Fixes = std::vector<Fix const*>;

/// Findings about the run itself (AX9…) do not concern a list.
void count(Counts& counts, Finding const& finding, SourceSet const& sources) {
  if (finding.code < cannot_read) ++counts[identity_of(finding, sources)];
}

/// No new finding, and at least one less: so every accepted step makes progress.
bool is_better(Counts const& after, Counts const& before) {
  bool fewer = after.size() < before.size();
  for (auto const& [identity, number] : after) {
    auto const known = before.find(identity);
    if (known == before.end() || known->second < number) return false;
    fewer = fewer || number < known->second;
  }
  return fewer;
}

class Fixer {
 public:
  Fixer(Workspace& workspace, FixChoice choice, Baseline const& baseline, IdentityPaths& identity_paths,
        ChangeableFiles const& changeable)
      : workspace_(workspace),
        choice_(choice),
        baseline_(baseline),
        identity_paths_(identity_paths),
        changeable_(changeable) {
    result_.edited = workspace.unsaved();
    result_.original = workspace.unsaved();
  }

  void fix(std::string const& path) {
    if (path == "-") keep(path);
    whole_programs_ = false;
    std::size_t left_out = 0;
    while (round(path, left_out)) {
    }
    result_.facts.left_out += left_out;
  }

  FixedInputs result() && { return std::move(result_); }

 private:
  /// Standard input can be read only once.
  void keep(std::string const& path) {
    if (result_.edited.contains(path)) return;
    auto bytes = workspace_.disk().read(path);
    if (auto* const text = std::get_if<std::string>(&bytes)) {
      result_.original.emplace(path, *text);
      result_.edited.emplace(path, std::move(*text));
    }
  }

  [[nodiscard]] validator::CheckOptions options_of(std::string const& path) const {
    auto options = workspace_.options_of(path);
    options.whole_programs = whole_programs_;
    return options;
  }

  /// None where the input cannot be read with these edits.
  [[nodiscard]] std::optional<Counts> findings_of(std::string const& path, EditedBytes const& edited) const {
    EditedFiles files(edited, workspace_.disk());
    SourceSet sources;
    Counts counts;
    auto const found = validator::check(files, path, options_of(path), sources,
                                        [&](Finding const& finding) { count(counts, finding, sources); });
    return found.unreadable ? std::nullopt : std::optional(std::move(counts));
  }

  /// Bytes passed in by the caller may always be changed.
  [[nodiscard]] bool may_change(std::string const& path) {
    auto const [known, is_new] =
        may_change_.try_emplace(path, path == "-" || workspace_.unsaved().contains(path));
    if (is_new && !known->second) known->second = changeable_.contains(path);
    return known->second;
  }

  [[nodiscard]] bool may_apply(Finding const& finding, SourceSet const& sources) {
    if (!finding.fix) return false;
    auto identity = identity_of(finding, sources);
    identity.file = identity_paths_.of(identity.file);
    if (baseline_.mentions(identity)) return false;
    auto const& edits = finding.fix->edits;
    bool const stays_inside = std::all_of(edits.begin(), edits.end(), [&](Edit const& edit) {
      return may_change(sources[edit.place.source].name());
    });
    if (!stays_inside) return false;
    return choice_ == FixChoice::all || finding.fix->safety == FixSafety::safe;
  }

  /// Long NC programs are held in memory only if one of them needs a repair.
  [[nodiscard]] bool repairs_excerpt(validator::CheckResult const& found, SourceSet const& sources) {
    return std::any_of(found.findings.begin(), found.findings.end(), [&](Finding const& finding) {
      return may_apply(finding, sources) &&
             std::any_of(finding.fix->edits.begin(), finding.fix->edits.end(),
                         [&](Edit const& edit) { return sources[edit.place.source].is_excerpt(); });
    });
  }

  /// True if a fix was applied. Of fixes that touch one another the first is applied; the others wait for the
  /// next round.
  bool round(std::string const& path, std::size_t& left_out) {
    SourceSet sources;
    EditedFiles files(result_.edited, workspace_.disk());
    auto const found = validator::check(files, path, options_of(path), sources);
    if (found.unreadable) {
      result_.failures.push_back(unreadable(path, *found.unreadable));
      return false;
    }
    if (!whole_programs_ && repairs_excerpt(found, sources)) {
      whole_programs_ = true;
      return round(path, left_out);
    }
    FixBatch batch(sources);
    Fixes fixes;
    for (auto const& finding : found.findings) {
      if (may_apply(finding, sources) && batch.add(*finding.fix)) fixes.push_back(&*finding.fix);
    }
    Counts counts;
    for (auto const& finding : found.findings) count(counts, finding, sources);
    Attempt attempt{.path = path,
                    .sources = sources,
                    .findings = std::move(counts),
                    .accepted = {},
                    .edited = result_.edited,
                    .checks = 0};
    accept(attempt, fixes);
    left_out = fixes.size() - attempt.accepted.size();
    if (attempt.accepted.empty()) return false;
    result_.facts.applied += attempt.accepted.size();
    keep_originals(attempt);
    result_.edited = std::move(attempt.edited);
    return true;
  }

  struct Attempt {
    std::string const& path;
    SourceSet const& sources;
    Counts findings;  ///< that are left with the accepted fixes
    Fixes accepted;
    EditedBytes edited;  ///< with the accepted fixes
    std::size_t checks = 0;
  };

  /// Applies all of `fixes` if that is an improvement, otherwise bisects to find those that are.
  void accept(Attempt& attempt, std::span<Fix const* const> fixes) const {
    if (fixes.empty() || ++attempt.checks > most_checks) return;
    FixBatch batch(attempt.sources);
    for (auto const* const fix : attempt.accepted) batch.add(*fix);
    for (auto const* const fix : fixes) batch.add(*fix);
    auto edited = result_.edited;
    for (auto& source : batch.apply()) {
      edited.insert_or_assign(attempt.sources[source.source].name(), std::move(source.bytes));
    }
    auto counts = findings_of(attempt.path, edited);
    if (counts && is_better(*counts, attempt.findings)) {
      attempt.findings = *std::move(counts);
      attempt.accepted.insert(attempt.accepted.end(), fixes.begin(), fixes.end());
      attempt.edited = std::move(edited);
    } else if (fixes.size() > 1) {
      accept(attempt, fixes.first(fixes.size() / 2));
      accept(attempt, fixes.subspan(fixes.size() / 2));
    }
  }

  void name(Fix const& fix, SourceSet const& sources) {
    auto const& source = sources[fix.edits.front().place.source];
    result_.facts.named.push_back({.file = source.name(),
                                   .line = source.position(fix.edits.front().place.span.begin).line,
                                   .title = fix.title});
  }

  void keep_originals(Attempt const& attempt) {
    for (auto const* const fix : attempt.accepted) {
      if (choice_ == FixChoice::all && !fix->edits.empty()) name(*fix, attempt.sources);
      for (auto const& edit : fix->edits) {
        auto const& source = attempt.sources[edit.place.source];
        result_.original.try_emplace(source.name(), *source.file());
      }
    }
  }

  Workspace& workspace_;
  FixChoice choice_;
  Baseline const& baseline_;
  IdentityPaths& identity_paths_;
  ChangeableFiles const& changeable_;
  std::unordered_map<std::string, bool> may_change_;  ///< by name of the source
  bool whole_programs_ = false;
  FixedInputs result_;
};

}  // namespace

FixedInputs fix_inputs(Workspace& workspace, std::vector<std::string> const& paths, FixChoice choice,
                       Baseline const& baseline, IdentityPaths& identity_paths,
                       ChangeableFiles const& changeable) {
  Fixer fixer(workspace, choice, baseline, identity_paths, changeable);
  for (auto const& path : paths) fixer.fix(path);
  return std::move(fixer).result();
}

}  // namespace axisc
