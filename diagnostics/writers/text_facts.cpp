#include "diagnostics/sentences.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/writers/writers.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace axisc::says {

constexpr Sentence fixed_one{"{count} finding was fixed", "{count} Befund wurde korrigiert"};
constexpr Sentence fixed_many{"{count} findings were fixed", "{count} Befunde wurden korrigiert"};
constexpr Sentence fixes_left_out_one{
    "{count} fix was left out: it would lead to another finding",
    "{count} Korrektur wurde ausgelassen: sie würde zu einem anderen Befund führen"};
constexpr Sentence fixes_left_out_many{
    "{count} fixes were left out: they would lead to other findings",
    "{count} Korrekturen wurden ausgelassen: sie würden zu anderen Befunden führen"};
constexpr Sentence baseline_recorded_one{"{count} finding was recorded in the baseline",
                                         "{count} Befund wurde in der Baseline festgehalten"};
constexpr Sentence baseline_recorded_many{"{count} findings were recorded in the baseline",
                                          "{count} Befunde wurden in der Baseline festgehalten"};
constexpr Sentence baseline_hidden_one{"{count} finding is hidden by the baseline",
                                       "{count} Befund ist durch die Baseline ausgeblendet"};
constexpr Sentence baseline_hidden_many{"{count} findings are hidden by the baseline",
                                        "{count} Befunde sind durch die Baseline ausgeblendet"};
constexpr Sentence baseline_stale{"the baseline holds {code} in {subject}, which is not found any more",
                                  "die Baseline enthält {code} in {subject}, das nicht mehr gefunden wird"};
constexpr Sentence baseline_stale_further_one{
    "{count} further entry of the baseline is not found any more",
    "{count} weiterer Eintrag der Baseline wird nicht mehr gefunden"};
constexpr Sentence baseline_stale_further_many{
    "{count} further entries of the baseline are not found any more",
    "{count} weitere Einträge der Baseline werden nicht mehr gefunden"};
constexpr Sentence statistics_fixable_one{"{count} with a fix", "{count} mit Korrektur"};
constexpr Sentence statistics_fixable_many{"{count} with fixes", "{count} mit Korrektur"};

}  // namespace axisc::says

namespace axisc {
namespace {

/// Limits the entries named: a run on one of many lists would otherwise name nearly the whole baseline.
constexpr std::size_t most_stale_entries = 10;

std::string stale_text(Identity const& identity, Language language) {
  std::string subject = identity.file;
  for (std::string const& part : {identity.axis, identity.parameter}) {
    if (!part.empty()) subject += (subject.empty() ? "" : " ") + part;
  }
  return render(
      {says::baseline_stale,
       {{.name = "code", .value = code_text(identity.code)}, {.name = "subject", .value = subject}}},
      language);
}

}  // namespace

std::string write_text_facts(RunFacts const& run, WriteOptions const& options) {
  Painter const paint(options.color);
  Language const language = options.language;
  std::string text;
  auto const add = [&](std::string const& sentence) {
    text += paint(Style::note, render({says::word_note}, language)) + ": " + printable(sentence) + '\n';
  };
  auto const add_counted = [&](std::size_t number, SentenceRef one, SentenceRef many) {
    add(render(counted(number, one, many), language));
  };
  if (run.fixes) {
    for (AppliedFix const& fix : run.fixes->named) {
      add(fix.file + ":" + std::to_string(fix.line) + ": " + render(fix.title, language));
    }
  }
  if (run.fixes && run.fixes->applied > 0) {
    add_counted(run.fixes->applied, says::fixed_one, says::fixed_many);
  }
  if (run.fixes && run.fixes->left_out > 0) {
    add_counted(run.fixes->left_out, says::fixes_left_out_one, says::fixes_left_out_many);
  }
  if (!run.baseline) return text;
  BaselineFacts const& baseline = *run.baseline;
  if (baseline.recorded) {
    add_counted(*baseline.recorded, says::baseline_recorded_one, says::baseline_recorded_many);
  } else if (baseline.hidden > 0) {
    add_counted(baseline.hidden, says::baseline_hidden_one, says::baseline_hidden_many);
  }
  std::size_t const shown = std::min(baseline.stale.size(), most_stale_entries);
  for (std::size_t i = 0; i < shown; ++i) add(stale_text(baseline.stale[i], language));
  if (shown < baseline.stale.size()) {
    add_counted(baseline.stale.size() - shown, says::baseline_stale_further_one,
                says::baseline_stale_further_many);
  }
  return text;
}

std::string write_text_statistics(std::vector<CodeCount> const& counts, WriteOptions const& options) {
  std::size_t width = 1;
  std::size_t name_width = 0;
  for (CodeCount const& row : counts) {
    width = std::max(width, std::to_string(row.count).size());
    name_width = std::max(name_width, row.name.size());
  }
  std::string text;
  for (CodeCount const& row : counts) {
    std::string const number = std::to_string(row.count);
    text += std::string(width - number.size(), ' ') + number + "  " + code_text(row.code) + "  " +
            std::string(row.name);
    if (row.fixable > 0) {
      Message const fixable =
          counted(row.fixable, says::statistics_fixable_one, says::statistics_fixable_many);
      text += std::string(name_width - row.name.size() + 2, ' ') + render(fixable, options.language);
    }
    text += '\n';
  }
  return text;
}

}  // namespace axisc
