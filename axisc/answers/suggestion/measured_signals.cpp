#include "axisc/answers/suggestion/measured_signals.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

namespace axisc::says {

constexpr Sentence choose_columns{
    "{file}: name the input with --in and the output with --out; there are {column}",
    "{file}: mit --in den Eingang und mit --out den Ausgang nennen; es gibt {column}"};
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

using recordings::Object;
using tuning::InputKind;

/// What excites the axis, and its answer.
struct Pair {
  Object in, out;
};
constexpr std::array pairs{Pair{.in = Object::torque, .out = Object::velocity},
                           Pair{.in = Object::command_position, .out = Object::actual_position}};

/// Input and output. Failure where they have to be named.
std::array<ChosenColumn, 2> chosen_columns(RecordingFile const& file, AxisPlace const& axis,
                                           SignalColumns const& wanted) {
  std::array<std::optional<ChosenColumn>, 2> chosen;
  if (wanted.in) chosen[0] = named_column(file, *wanted.in);
  if (wanted.out) chosen[1] = named_column(file, *wanted.out);
  for (auto const& pair : pairs) {
    if (chosen[0] || chosen[1]) break;
    auto const in = find_column(file, axis, pair.in, "--in");
    auto const out = find_column(file, axis, pair.out, "--out");
    if (in && out) chosen = {in, out};
  }
  bool const is_plain = file.recording.form == recordings::Form::columns;
  if (is_plain && file.recording.channels.size() == 2) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (chosen.at(i)) continue;
      auto const& other = chosen.at(1 - i);
      chosen.at(i) = ChosenColumn{.channel = other ? 1 - other->channel : i, .by = FoundBy::order};
    }
  }
  if (chosen[0] && chosen[1]) return {*chosen[0], *chosen[1]};
  throw Failure({says::choose_columns, {{"file", file.name}, {"column", file.known()}}}, csv_malformed);
}

template <std::size_t size>
bool has_one_of(std::string const& text, std::array<std::string_view, size> const& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// By the object that it is, else by its name and unit. What says nothing is a position.
InputKind kind_of(recordings::Channel const& channel, ChosenColumn const& column) {
  if (column.object) {
    auto const object = column.object->object;
    return object == Object::torque     ? InputKind::force
           : object == Object::velocity ? InputKind::velocity
                                        : InputKind::position;
  }
  constexpr std::array<std::string_view, 2> positions{"position", "lage"};
  constexpr std::array<std::string_view, 6> forces{"torque",     "force", "current",
                                                   "drehmoment", "kraft", "strom"};
  constexpr std::array<std::string_view, 3> force_units{"[N]", "[Nm]", "[A]"};
  constexpr std::array<std::string_view, 7> velocities{"veloc", "speed", "geschw", "drehzahl",
                                                       "/s]",   "/min]", "rpm"};
  auto const written = channel.name + " [" + channel.unit + "]";
  auto const name = ascii::lower_case(written);
  if (has_one_of(name, velocities)) return InputKind::velocity;
  if (has_one_of(name, positions)) return InputKind::position;
  bool const is_force = has_one_of(name, forces) || has_one_of(written, force_units);
  return is_force ? InputKind::force : InputKind::position;
}

/// In brackets behind the name, else the channel's; empty where neither names one.
std::string named_unit(recordings::Channel const& channel) {
  std::string named(recordings::unit_in_brackets(channel.name));
  return named.empty() && recordings::names_unit(channel.unit) ? channel.unit : named;
}

/// Converts a setpoint into mm or degrees where the file or the object says what it is in.
std::string convert(std::vector<double>& setpoint, recordings::Channel const& channel,
                    ChosenColumn const& column, bool is_rotary) {
  auto const named = named_unit(channel);
  auto thousandths = recordings::thousandths_in(named);
  bool const is_position =
      column.object && recordings::row_of(column.object->object).unit == recordings::ObjectUnit::position;
  constexpr double tenth = 0.1;
  if (!thousandths && named.empty() && is_position && channel.scale.is_identity()) thousandths = tenth;
  if (!thousandths) return repair_utf8(named);
  constexpr double per_thousandth = 1e-3;
  for (double& value : setpoint) value *= *thousandths * per_thousandth;
  return is_rotary ? "°" : "mm";
}

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

/// Velocities become those a second; the unit of what they cover in it, empty where theirs is not named.
std::string distance_unit(std::vector<double>& velocities, std::string const& unit) {
  constexpr std::string_view a_second = "/s", a_minute = "/min";
  constexpr double seconds_per_minute = 60;
  if (unit.ends_with(a_second)) return unit.substr(0, unit.size() - a_second.size());
  if (!unit.ends_with(a_minute)) return unit.empty() ? unit : unit + " s";
  for (double& velocity : velocities) velocity /= seconds_per_minute;
  return unit.substr(0, unit.size() - a_minute.size());
}

}  // namespace

MeasuredSignals measured_signals(RecordingFile const& file, MeasuredAxis const& axis,
                                 SignalColumns const& columns) {
  auto const chosen = chosen_columns(file, axis.place, columns);
  double const sample_time = sample_time_of(file, chosen, axis.cycle_ms);
  auto const joined = cycles_of(file, std::array{chosen[0].channel, chosen[1].channel}, sample_time);
  if (!joined.gaps.empty()) {
    throw Failure({says::uneven_time, {{"place", file.place(chosen[0].channel, joined.gaps.front())}}},
                  csv_malformed);
  }
  auto const& in = file.recording.channels[chosen[0].channel];
  constexpr double per_second = 1000;
  MeasuredSignals found{.measurement = {.kind = tuning::MeasurementKind::signals,
                                        .response = {},
                                        .in = joined.signals[0].values(),
                                        .out = joined.signals[1].values(),
                                        .sampling_rate = per_second / sample_time,
                                        .input = kind_of(in, chosen[0])},
                        .mapping = {mapped_column(file, chosen[0]), mapped_column(file, chosen[1])},
                        .unit = {}};
  if (found.measurement.input == InputKind::position) {
    found.unit = convert(found.measurement.in, in, chosen[0], axis.is_rotary);
  } else if (found.measurement.input == InputKind::velocity) {
    found.unit = distance_unit(found.measurement.in, named_unit(in));
  }
  return found;
}

}  // namespace axisc
