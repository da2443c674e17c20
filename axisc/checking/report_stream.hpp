// The report of a run, printed during the run: findings are freed as soon as those of all earlier inputs are
// printed.
#pragma once

#include "axisc/checking/baseline.hpp"
#include "axisc/checking/checked_input.hpp"
#include "axisc/checking/identity_paths.hpp"
#include "axisc/checking/report_format.hpp"
#include "axisc/environment/text_sink.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace axisc {

struct ReportPlan {
  ReportFormat report_format;
  bool quiet = false;
  bool statistics = false;
  bool counts_always = false;        ///< the last line of the text form also where nothing was found
  std::optional<Baseline> baseline;  ///< its findings are not shown
  bool write_baseline = false;       ///< `baseline` is to be replaced by the findings
  IdentityPaths* identity_paths = nullptr;
};

class ReportStream {
 public:
  ReportStream(ReportPlan plan, TextSink out);

  /// A finding of the input that will be added next.
  void add(Finding const& finding, SourceSet const& sources);
  /// The rest of an input.
  void add(CheckedInput const& checked);
  /// An input that could not be read, for formats that list failures.
  void fail(Failure const& failure);

  /// Counts of the findings shown.
  [[nodiscard]] FindingCounts const& counts() const { return counts_; }
  [[nodiscard]] std::unordered_set<std::string> const& files() const { return files_; }
  /// With `write_baseline`: all findings.
  [[nodiscard]] Baseline const& found() const { return found_; }

  /// Prints the rest. `judged` returns whether the run looks for a baseline entry's code.
  void finish(std::optional<FixFacts> fixes, std::function<bool(Code)> const& judged);

 private:
  void count(Finding const& finding);
  /// The identity with its file named as in the repository.
  [[nodiscard]] Identity const& identify(Finding const& finding, SourceSet const& sources);
  [[nodiscard]] bool is_hidden(Identity const& identity, std::uint32_t occurrence);
  /// Takes an entry of the baseline whose file is gone, if one fits.
  [[nodiscard]] bool was_elsewhere(Identity const& identity, std::uint32_t occurrence);
  [[nodiscard]] std::optional<BaselineFacts> baseline_facts(std::function<bool(Code)> const& judged) const;
  void write(Finding const& finding, SourceSet const& sources, std::string_view fingerprint);
  /// Passes on the text written so far.
  void print();
  [[nodiscard]] std::vector<CodeCount> frequent_codes() const;

  ReportPlan plan_;
  TextSink out_;
  std::unique_ptr<ReportWriter> writer_;
  std::string text_;              ///< written and not printed yet
  bool numbers_;                  ///< identities matter to the format or the baseline
  bool assumption_said_ = false;  ///< AX9006
  Identity identity_;             ///< of the last finding; its memory serves the next
  bool has_failed_ = false;
  std::unordered_set<std::string> files_;
  FindingCounts counts_;
  std::map<Code, CodeCount> codes_;
  /// Keyed by a hash of the identity, because a fleet has millions of them.
  std::unordered_map<std::uint64_t, std::uint32_t> occurrences_;
  Baseline found_;
  Baseline missing_;  ///< entries that no finding has matched so far
  /// Files of entries of the baseline that are gone, by the entry without its file.
  std::optional<std::multimap<BaselineEntry, std::string>> gone_;
  std::size_t hidden_ = 0;
};

}  // namespace axisc
