#include "axisc/files/recorded_columns.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/row_problem.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace axisc::says {

constexpr Sentence no_column{"{file} has no column \"{column}\"; it has {known}",
                             "{file} hat keine Spalte \"{column}\"; vorhanden sind {known}"};
constexpr Sentence which_columns{
    "{file} has the columns {known}; name the setpoint before the filters with --in and behind them with "
    "--out",
    "{file} hat die Spalten {known}; den Sollwert vor den Filtern mit --in und den dahinter mit --out "
    "nennen"};
constexpr Sentence other_cycle{
    "{file}:{line}: {step} ms passed since the line before, which is not a whole number of cycles of {cycle} "
    "ms; record with the NC cycle",
    "{file}:{line}: seit der Zeile davor vergingen {step} ms, das ist keine ganze Zahl von Zyklen von "
    "{cycle} ms; mit dem NC-Zyklus aufzeichnen"};
constexpr Sentence no_position{
    R"({file}:{line}: {value} in column "{column}" is too large for a position; delete the row, or name another column)",
    R"({file}:{line}: {value} in Spalte "{column}" ist zu groß für eine Position; die Zeile löschen oder eine andere Spalte nennen)"};
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
    throw Failure({.sentence = sentence, .arguments = std::move(arguments)}, csv_malformed);
  }
};

struct Layout {
  std::size_t input = 0, output = 0;
  std::optional<std::size_t> time;
  double ms_per_unit = 1;
};

bool is_time(std::string_view name) {
  auto const begin = name.substr(0, 4);
  return ascii::equal_ignoring_case(begin, "time") || ascii::equal_ignoring_case(begin, "zeit");
}

std::string known(std::vector<std::string> const& names) {
  std::string text;
  for (auto const& name : names) text += (text.empty() ? "\"" : ", \"") + shown_column(name) + "\"";
  return text;
}

std::size_t index_of(std::string const& wanted, File const& file) {
  auto const& names = file.rows.names();
  auto const found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  auto const number = parse_count(wanted);
  if (number && *number >= 1 && *number <= names.size()) return static_cast<std::size_t>(*number - 1);
  file.fail(says::no_column, {{"column", wanted}, {"known", known(names)}});
}

Layout layout_of(File const& file, WantedColumns const& wanted) {
  auto const& names = file.rows.names();
  auto const columns = names.size();
  std::vector<bool> times(columns, false);
  std::vector<std::size_t> values;
  for (std::size_t i = 0; i < columns; ++i) {
    times[i] =
        file.rows.is_named() ? is_time(names[i]) : (columns == 4 && i % 2 == 0) || (columns == 3 && i == 0);
    if (!times[i]) values.push_back(i);
  }
  if ((!wanted.input || !wanted.output) && values.size() != 2) {
    file.fail(says::which_columns, {{"known", known(names)}});
  }
  Layout layout;
  layout.input = wanted.input ? index_of(*wanted.input, file) : values[0];
  layout.output = wanted.output ? index_of(*wanted.output, file) : values[1];
  for (std::size_t i = 0; i < layout.input; ++i) {
    if (times[i]) layout.time = i;
  }
  if (!layout.time) return layout;
  std::string_view const name = names[*layout.time];
  if (name.ends_with("_s") || name.ends_with("[s]")) layout.ms_per_unit = 1000;
  return layout;
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

void add_missing(comparison::Recording& recording, double input, double output, std::size_t missing) {
  for (std::size_t i = 0; i < missing; ++i) recording.gaps.push_back(recording.input.size() + i);
  bridge(recording.input, input, missing);
  bridge(recording.output, output, missing);
}

}  // namespace

RecordedColumns read_recorded_columns(std::string const& name, recordings::ByteSource source,
                                      WantedColumns const& wanted, design::CycleTime cycle_time) {
  NumberRows rows(std::move(source));
  if (rows.problem()) fail_row(rows, name);
  File const file{name, rows};
  auto const layout = layout_of(file, wanted);
  std::vector<std::size_t> columns{layout.input, layout.output};
  if (layout.time) columns.push_back(*layout.time);
  rows.read_only(columns);
  RecordedColumns recorded{
      .input_name = rows.names()[layout.input], .output_name = rows.names()[layout.output], .recording = {}};
  auto& recording = recorded.recording;
  double const cycle_ms = cycle_time.microseconds() / 1000;
  double last_time = 0;
  std::vector<double> row(rows.names().size());
  for (std::size_t count = 0; next_row(rows, row, name); ++count) {
    double const input = row[layout.input];
    double const output = row[layout.output];
    for (std::size_t const column : {layout.input, layout.output}) {
      if (std::abs(row[column]) <= largest_position) continue;
      file.fail(says::no_position,
                {{"value", format_rounded(row[column], 6)}, {"column", shown_column(rows.names()[column])}});
    }
    std::size_t passed = 1;
    if (layout.time) {
      double const time = row[*layout.time] * layout.ms_per_unit;
      if (count > 0) passed = passed_cycles(file, time - last_time, cycle_ms);
      last_time = time;
    }
    if (passed == 0) {
      ++recorded.repeated;
      continue;
    }
    if (passed > 1) add_missing(recording, input, output, passed - 1);
    if (recording.gaps.size() > always_bearable + recording.input.size() / 4) {
      file.fail(says::many_lost, {{"cycle", format_rounded(cycle_ms, 6)}});
    }
    recording.input.push(input);
    recording.output.push(output);
  }
  return recorded;
}

}  // namespace axisc
