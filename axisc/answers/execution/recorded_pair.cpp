#include "axisc/answers/execution/recorded_pair.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/format_number.hpp"

#include <cmath>
#include <tuple>

namespace axisc::says {

constexpr Sentence one_sample{"{file} has only one row of numbers: record for longer",
                              "{file} hat nur eine Zeile von Zahlen: länger aufzeichnen"};
constexpr Sentence uneven_time{"{place}: samples are missing; record again without gaps",
                               "{place}: Abtastwerte fehlen; noch einmal ohne Lücken aufzeichnen"};
constexpr Sentence other_sample_time{
    "{file}: column {in} has a sample every {first} ms, column {out} every {second} ms; record both with one "
    "sample time",
    "{file}: Spalte {in} hat alle {first} ms einen Abtastwert, Spalte {out} alle {second} ms; beide mit "
    "einer Abtastzeit aufzeichnen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// ms; the same of both columns.
double sample_time_of(RecordingFile const& file, std::array<ChosenColumn, 2> const& columns,
                      double cycle_ms) {
  auto const& [channels, clocks] = std::tie(file.recording.channels, file.recording.clocks);
  std::array<double, 2> times{};
  for (std::size_t i = 0; i < 2; ++i) {
    auto const channel = columns.at(i).channel;
    auto const& clock = clocks[channels[channel].clock];
    if (clock.problem) fail_clock(file, channel);
    if (clock.samples < 2) throw Failure({says::one_sample, {{"file", file.name}}}, csv_malformed);
    times.at(i) = recordings::sample_time(clock);
    if (clock.is_counted && !(times.at(i) > 0)) times.at(i) = cycle_ms;
  }
  constexpr double alike = 0.01;
  if (std::abs(times[0] - times[1]) > alike * times[0]) {
    throw Failure({says::other_sample_time,
                   {{"file", file.name},
                    {"in", shown_column(channels[columns[0].channel].name)},
                    {"out", shown_column(channels[columns[1].channel].name)},
                    {"first", format_rounded(times[0], 6)},
                    {"second", format_rounded(times[1], 6)}}},
                  csv_malformed);
  }
  return times[0];
}

}  // namespace

RecordedPair recorded_pair(RecordingFile const& file, std::array<ChosenColumn, 2> const& columns,
                           double cycle_ms) {
  double const sample_time = sample_time_of(file, columns, cycle_ms);
  auto joined = cycles_of(file, std::array{columns[0].channel, columns[1].channel}, sample_time);
  if (!joined.gaps.empty()) {
    throw Failure({says::uneven_time, {{"place", file.place(columns[0].channel, joined.gaps.front())}}},
                  csv_malformed);
  }
  return {.signals = std::move(joined), .sample_time_ms = sample_time};
}

}  // namespace axisc
