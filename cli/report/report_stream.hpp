// The report of a run, printed during the run: findings are freed as soon as those of all earlier inputs are printed.
#pragma once

#include "cli/checking/baseline.hpp"
#include "cli/checking/checked_input.hpp"
#include "cli/checking/identity_paths.hpp"
#include "cli/fleet/shard_record.hpp"
#include "cli/report/console.hpp"
#include "cli/report/spool.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace axisc::cli {

struct ReportPlan {
  ReportFormat report_format;
  bool quiet = false;
  bool statistics = false;
  bool counts_always = false;        ///< the last line of the text form also where nothing was found
  std::optional<Baseline> baseline;  ///< what it holds is not shown
  bool write_baseline = false;       ///< `baseline` is to be what was found
  std::optional<ShardRecord> shard;  ///< for `axisc merge`
  IdentityPaths* identity_paths = nullptr;
};

class ReportStream {
 public:
  ReportStream(ReportPlan plan, Console& out);

  /// Inputs come by rising `number`, their index among all inputs of the run.
  void add(std::size_t number, CheckedInput const& checked);
  /// A finding of the input that will be added next.
  void add(WrittenFinding const& finding);
  /// An input that could not be read, for formats that list failures.
  void fail(std::size_t order, Failure const& failure);

  /// Counts of the findings shown.
  [[nodiscard]] FindingCounts const& counts() const { return counts_; }
  [[nodiscard]] std::unordered_set<std::string> const& files() const { return files_; }
  /// With `write_baseline`: all findings.
  [[nodiscard]] Baseline const& found() const { return found_; }

  /// Prints the rest. `judged` tells whether the run looks for a baseline entry's code. `status` is the exit status of
  /// the run, for a shard.
  void finish(std::optional<FixFacts> fixes, std::function<bool(Code)> const& judged, int status);

 private:
  void count(WrittenFinding const& finding);
  /// Its index in the list of artifacts; it is appended if missing.
  [[nodiscard]] std::size_t number_of(Artifact const& artifact);
  /// The identity with its file named as in the repository.
  [[nodiscard]] Identity const& identify(WrittenFinding const& finding);
  [[nodiscard]] bool is_hidden(Identity const& identity, std::uint32_t occurrence);
  /// Takes an entry of the baseline whose file is gone, if one fits.
  [[nodiscard]] bool was_elsewhere(Identity const& identity, std::uint32_t occurrence);
  [[nodiscard]] std::optional<BaselineFacts> baseline_facts(std::function<bool(Code)> const& judged) const;
  void print(WrittenFinding const& finding, Identity const& identity, std::uint32_t occurrence);
  void print_sarif();
  [[nodiscard]] std::vector<CodeCount> frequent_codes() const;

  ReportPlan plan_;
  Console& out_;
  bool numbers_;                  ///< identities matter to the format or the baseline
  bool assumption_said_ = false;  ///< AX9006
  Identity identity_;             ///< of the last finding; its memory serves the next
  std::size_t shown_ = 0;         ///< findings of the input that is added next
  std::set<std::uint32_t> used_;  ///< their artifacts
  bool has_elements_ = false;
  std::unordered_set<std::string> files_;
  FindingCounts counts_;
  std::map<Code, CodeCount> codes_;
  /// Keyed by a digest of the identity, because a fleet has millions of them.
  std::unordered_map<std::uint64_t, std::uint32_t> occurrences_;
  Baseline found_;
  Baseline missing_;  ///< entries that nothing has answered to so far
  /// Files of entries of the baseline that are gone, by the entry without its file.
  std::optional<std::multimap<BaselineEntry, std::string>> gone_;
  std::size_t hidden_ = 0;
  Spool sarif_results_;
  std::vector<Artifact> artifacts_;
  std::unordered_map<std::string, std::size_t> artifact_numbers_;
};

}  // namespace axisc::cli
