#include "diagnostics/terminal.hpp"
#include "diagnostics/writers.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace axisc {
namespace {

/// A run over one of many lists would otherwise name nearly the whole baseline.
constexpr std::size_t most_stale_entries = 10;

std::string counted(std::size_t number, Text one, Text many, Language language) {
  return render(
      {.text = number == 1 ? one : many, .arguments = {{.name = "count", .value = std::to_string(number)}}},
      language);
}

std::string stale_text(Identity const& identity, Language language) {
  std::string const subject =
      identity.parameter.empty() ? identity.axis : identity.axis + ' ' + identity.parameter;
  return render({.text = Text::baseline_stale,
                 .arguments = {{.name = "code", .value = code_text(identity.code)},
                               {.name = "subject", .value = subject}}},
                language);
}

}  // namespace

std::string write_text_facts(RunFacts const& run, WriteOptions const& options) {
  Painter const paint(options.color);
  Language const language = options.language;
  std::string text;
  auto const add = [&](std::string const& sentence) {
    text += paint(Style::note, render({.text = Text::word_note, .arguments = {}}, language)) + ": " +
            printable(sentence) + '\n';
  };
  if (run.fixes && run.fixes->applied > 0) {
    add(counted(run.fixes->applied, Text::fixed_one, Text::fixed_many, language));
  }
  if (run.fixes && run.fixes->left_out > 0) {
    add(counted(run.fixes->left_out, Text::fixes_left_out_one, Text::fixes_left_out_many, language));
  }
  if (!run.baseline) return text;
  BaselineFacts const& baseline = *run.baseline;
  if (baseline.recorded) {
    add(counted(*baseline.recorded, Text::baseline_recorded_one, Text::baseline_recorded_many, language));
  } else if (baseline.hidden > 0) {
    add(counted(baseline.hidden, Text::baseline_hidden_one, Text::baseline_hidden_many, language));
  }
  std::size_t const shown = std::min(baseline.stale.size(), most_stale_entries);
  for (std::size_t i = 0; i < shown; ++i) add(stale_text(baseline.stale[i], language));
  if (shown < baseline.stale.size()) {
    add(counted(baseline.stale.size() - shown, Text::baseline_stale_further_one,
                Text::baseline_stale_further_many, language));
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
      text +=
          std::string(name_width - row.name.size() + 2, ' ') +
          counted(row.fixable, Text::statistics_fixable_one, Text::statistics_fixable_many, options.language);
    }
    text += '\n';
  }
  return text;
}

}  // namespace axisc
