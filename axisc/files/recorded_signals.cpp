#include "axisc/files/recorded_signals.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/row_problem.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace axisc::says {

constexpr Sentence no_column{"{file} has no column \"{column}\"; it has {known}",
                             "{file} hat keine Spalte \"{column}\"; vorhanden sind {known}"};
constexpr Sentence other_cycle{
    "{file}:{line}: {step} ms passed since the line before, which is not a whole number of cycles of {cycle} "
    "ms; record with the NC cycle",
    "{file}:{line}: seit der Zeile davor vergingen {step} ms, das ist keine ganze Zahl von Zyklen von "
    "{cycle} ms; mit dem NC-Zyklus aufzeichnen"};
constexpr Sentence no_position{
    "{file}:{line}: {value} in column \"{column}\" is too large for a position; delete the row, or name "
    "another column",
    "{file}:{line}: {value} in Spalte \"{column}\" ist zu groß für eine Position; die Zeile löschen oder "
    "eine andere Spalte nennen"};
constexpr Sentence many_lost{
    "{file}:{line}: more than a quarter of the cycles is missing by the column of the time; record every NC "
    "cycle of {cycle} ms",
    "{file}:{line}: nach der Zeitspalte fehlt mehr als ein Viertel der Zyklen; jeden NC-Zyklus von {cycle} "
    "ms aufzeichnen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// Beyond it whole numbers are no longer exact, and squares of differences overflow sooner or later.
constexpr double largest_position = 1e15;
/// A longer pause is not a lost sample.
constexpr double longest_gap = 1000;
constexpr double cycle_tolerance = 0.1;
/// More than a quarter of a short recording may be missing.
constexpr std::size_t always_bearable = 2000;

using recordings::NumberRows;

/// The rows of a file, for messages.
struct File {
  std::string const& name;
  NumberRows& rows;

  [[noreturn]] void fail(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    arguments.push_back({"file", name});
    arguments.push_back({"line", std::to_string(rows.line())});
    throw Failure({sentence, std::move(arguments)}, csv_malformed);
  }
};

bool is_time(std::string_view name) {
  auto const begin = name.substr(0, 4);
  return ascii::equal_ignoring_case(begin, "time") || ascii::equal_ignoring_case(begin, "zeit");
}

std::vector<bool> time_columns(NumberRows const& rows) {
  auto const columns = rows.names().size();
  std::vector<bool> times(columns, false);
  for (std::size_t i = 0; i < columns; ++i) {
    times[i] =
        rows.is_named() ? is_time(rows.names()[i]) : (columns == 4 && i % 2 == 0) || (columns == 3 && i == 0);
  }
  return times;
}

/// The column of the time, and what one of its units is in ms.
struct Clock {
  std::size_t column = 0;
  double ms_per_unit = 1;
};

/// The last one before the first signal.
std::optional<Clock> clock_of(ColumnNames const& columns, std::size_t first) {
  for (std::size_t i = first; i-- > 0;) {
    if (!columns.is_time[i]) continue;
    std::string_view const name = columns.names[i];
    bool const is_seconds = name.ends_with("_s") || name.ends_with("[s]");
    return Clock{.column = i, .ms_per_unit = is_seconds ? 1000.0 : 1.0};
  }
  return std::nullopt;
}

/// Values between the last one and `next`.
void bridge(comparison::Signal& signal, double next, std::size_t missing) {
  double const last = signal.back();
  for (std::size_t i = 1; i <= missing; ++i) {
    signal.push(last + (next - last) * static_cast<double>(i) / static_cast<double>(missing + 1));
  }
}

/// Cycles since the previous row, by the column of the time.
std::size_t passed_cycles(File const& file, double milliseconds, double cycle_ms) {
  double const cycles = milliseconds / cycle_ms;
  double const whole = std::round(cycles);
  bool const is_whole = std::abs(cycles - whole) <= cycle_tolerance && whole >= 0 && whole <= longest_gap;
  if (!is_whole) {
    file.fail(says::other_cycle,
              {{"step", format_rounded(milliseconds, 6)}, {"cycle", format_rounded(cycle_ms, 6)}});
  }
  return static_cast<std::size_t>(whole);
}

void refuse_huge(File const& file, double value, std::size_t column) {
  if (std::abs(value) <= largest_position) return;
  file.fail(says::no_position,
            {{"value", format_rounded(value, 6)}, {"column", shown_column(file.rows.names()[column])}});
}

}  // namespace

std::size_t ColumnNames::index_of(std::string const& wanted) const {
  auto const found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  auto const number = parse_count(wanted);
  if (number && *number >= 1 && *number <= names.size()) return static_cast<std::size_t>(*number - 1);
  throw Failure({says::no_column, {{"file", file}, {"column", wanted}, {"known", known()}}}, csv_malformed);
}

std::vector<std::size_t> ColumnNames::values() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_time[i]) found.push_back(i);
  }
  return found;
}

std::string ColumnNames::known() const {
  std::string text;
  for (auto const& name : names) text += (text.empty() ? "\"" : ", \"") + shown_column(name) + "\"";
  return text;
}

RecordedSignals read_recorded_signals(std::string const& name, recordings::ByteSource source,
                                      ChooseColumns const& choose, design::CycleTime cycle_time) {
  NumberRows rows(std::move(source));
  if (rows.problem()) fail_row(rows, name);
  File const file{name, rows};
  ColumnNames const known{.file = name, .names = rows.names(), .is_time = time_columns(rows)};
  auto columns = choose(known);
  auto const clock = clock_of(known, columns.front());
  RecordedSignals recorded{.names = {}, .signals = {}, .gaps = {}};
  for (auto const column : columns) recorded.names.push_back(rows.names()[column]);
  recorded.signals.resize(columns.size());
  auto read = columns;
  if (clock) read.push_back(clock->column);
  rows.read_only(read);
  double const cycle_ms = cycle_time.microseconds() / 1000;
  double last_time = 0;
  std::vector<double> row(rows.names().size());
  for (std::size_t count = 0; next_row(rows, row, name); ++count) {
    for (auto const column : columns) refuse_huge(file, row[column], column);
    std::size_t passed = 1;
    if (clock) {
      double const time = row[clock->column] * clock->ms_per_unit;
      if (count > 0) passed = passed_cycles(file, time - last_time, cycle_ms);
      last_time = time;
    }
    if (passed == 0) {
      ++recorded.repeated;
      continue;
    }
    auto const cycles = recorded.signals.front().size();
    for (std::size_t i = 1; i < passed; ++i) recorded.gaps.push_back(cycles + i - 1);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      auto& signal = recorded.signals[i];
      if (passed > 1) bridge(signal, row[columns[i]], passed - 1);
      signal.push(row[columns[i]]);
    }
    if (recorded.gaps.size() > always_bearable + recorded.signals.front().size() / 4) {
      file.fail(says::many_lost, {{"cycle", format_rounded(cycle_ms, 6)}});
    }
  }
  return recorded;
}

}  // namespace axisc
