#include "axisc/answers/suggestion/measured_signals.hpp"

#include "axisc/answers/execution/recorded_kind.hpp"
#include "axisc/answers/execution/recorded_pair.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
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
  auto const [signals, sample_time] = recorded_pair(file, chosen, axis.cycle_ms);
  auto const& in = file.recording.channels[chosen[0].channel];
  constexpr double per_second = 1000;
  MeasuredSignals found{.measurement = {.kind = tuning::MeasurementKind::signals,
                                        .response = {},
                                        .in = signals.signals[0].values(),
                                        .out = signals.signals[1].values(),
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
