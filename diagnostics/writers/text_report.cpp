#include "diagnostics/location.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace axisc::says {

constexpr Sentence same_elsewhere{"the same in more places: {count}",
                                  "dasselbe an weiteren Stellen: {count}"};
constexpr Sentence more_places{"… and {count} more, which --format jsonl shows",
                               "… und {count} weitere, die --format jsonl zeigt"};

}  // namespace axisc::says

namespace axisc {
namespace {

/// A printed finding, and the other places with the same words about the same text.
struct Seen {
  Finding headline;  ///< without its places
  std::vector<std::string> places;
  std::size_t count = 0;
};

class TextReport final : public ReportWriter {
 public:
  explicit TextReport(WriteOptions const& options) : options_(options) {}

  void add(std::string& out, Finding const& finding, SourceSet const& sources,
           std::string_view /*fingerprint*/) override {
    if (is_repeated(finding, sources)) return;
    (out += write_text(finding, sources, options_)) += '\n';
  }

  void add_failure(std::string const& /*sentence*/) override { ++failures_; }

  void end(Print const& print, RunFacts const& run) override {
    for (auto const& seen : seen_) {
      if (seen.count > 0) print(repetitions_of(seen));
    }
    if (run.statistics && !run.codes.empty()) print(write_text_statistics(run.codes, options_) + "\n");
    if (!run.has_summary) return;
    print(write_text_facts(run, options_) + write_text_summary(run.files, run.counts, options_, failures_));
  }

 private:
  /// At most this many are told apart; further findings of a run are printed, repeated or not.
  static constexpr std::size_t most_seen = 1000;
  static constexpr std::size_t most_places = 20;

  [[nodiscard]] bool is_repeated(Finding const& finding, SourceSet const& sources) {
    if (!finding.place || !finding.related.empty()) return false;
    auto const& source = sources[finding.place->source];
    auto const at = locate(*finding.place, sources);
    std::string room;
    auto key = whole_message(finding, options_.language);
    (key += '\n') += source.utf8(source.shown_line(at.begin.line), room);
    auto const known = indices_.find(key);
    if (known == indices_.end()) {
      if (seen_.size() == most_seen) return false;
      indices_.emplace(std::move(key), seen_.size());
      auto& headline = seen_.emplace_back().headline;
      headline.code = finding.code;
      headline.severity = finding.severity;
      headline.message = finding.message;
      return false;
    }
    auto& seen = seen_[known->second];
    ++seen.count;
    if (seen.places.size() < most_places) {
      seen.places.push_back(printable(at.file) + ":" + std::to_string(at.begin.line) + ":" +
                            std::to_string(at.begin.column));
    }
    return true;
  }

  [[nodiscard]] std::string repetitions_of(Seen const& seen) const {
    auto headline = seen.headline;
    headline.notes.push_back({says::same_elsewhere, {{"count", std::to_string(seen.count)}}});
    auto text = write_text(headline, {}, options_);
    for (auto const& place : seen.places) ((text += "  ::: ") += place) += '\n';
    if (seen.count > seen.places.size()) {
      auto const left = std::to_string(seen.count - seen.places.size());
      (text += "  ") += render({says::more_places, {{"count", left}}}, options_.language);
      text += '\n';
    }
    return text + "\n";
  }

  WriteOptions options_;
  std::unordered_map<std::string, std::size_t> indices_;  ///< into `seen_`, by the whole wording
  std::deque<Seen> seen_;
  std::size_t failures_ = 0;
};

}  // namespace

std::unique_ptr<ReportWriter> text_report(WriteOptions const& options) {
  return std::make_unique<TextReport>(options);
}

}  // namespace axisc
