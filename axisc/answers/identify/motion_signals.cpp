#include "axisc/answers/identify/motion_signals.hpp"

#include "analysis/comparison/turns.hpp"
#include "axisc/answers/execution/recorded_kind.hpp"
#include "axisc/answers/execution/recorded_pair.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence which_actual{
    "{file} does not show which column is the actual position of axis {axis}; name it with --actual COLUMN; "
    "there are {known}",
    "{file} zeigt nicht, welche Spalte die Istposition der Achse {axis} ist; sie mit --actual SPALTE nennen; "
    "vorhanden sind {known}"};
constexpr Sentence which_force{
    "{file} does not show which column is the torque or force of axis {axis}; name it with --force COLUMN; "
    "there are {known}",
    "{file} zeigt nicht, welche Spalte Drehmoment oder Kraft der Achse {axis} ist; sie mit --force SPALTE "
    "nennen; vorhanden sind {known}"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Object;
using tuning::InputKind;

/// Names of setpoints and of differences.
bool is_other_position(std::string const& name) {
  constexpr std::array<std::string_view, 7> words{"set",    "soll",  "command", "filter",
                                                  "target", "error", "abweich"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool is_called(recordings::Channel const& channel, std::size_t index, InputKind wanted) {
  auto const name = ascii::lower_case(channel.name);
  if (is_other_position(name)) return false;
  if (kind_of(channel, {.channel = index}) != wanted) return false;
  if (wanted == InputKind::force) return true;
  // What says nothing is a position for kind_of().
  constexpr std::array<std::string_view, 6> words{"position", "lage",   "actual",
                                                  "istwert",  "actpos", "istpos"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// "X" of "Torque X [Nm]".
bool names_axis(std::string_view name, std::string_view axis) {
  for (std::size_t begin = 0; begin < name.size();) {
    auto const end = std::min(name.find_first_of(" ._", begin), name.size());
    if (ascii::equal_ignoring_case(name.substr(begin, end - begin), axis)) return true;
    begin = end + 1;
  }
  return false;
}

/// The only column that is called so; of several, the only one that names the axis.
std::optional<ChosenColumn> column_by_name(RecordingFile const& file, std::string const& axis,
                                           InputKind wanted) {
  auto const& channels = file.recording.channels;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (is_called(channels[i], i, wanted)) found.push_back(i);
  }
  if (found.size() > 1) {
    std::erase_if(found, [&](std::size_t i) { return !names_axis(channels[i].name, axis); });
  }
  if (found.size() != 1) return std::nullopt;
  return ChosenColumn{.channel = found.front(), .by = FoundBy::name};
}

struct Wanted {
  Object object;
  InputKind kind;
  std::string_view option;
  SentenceRef missing;
};

ChosenColumn chosen_column(RecordingFile const& file, AxisPlace const& axis, Wanted const& wanted,
                           std::optional<std::string> const& named) {
  if (named) return named_column(file, *named);
  if (auto found = find_column(file, axis, wanted.object, wanted.option)) return *found;
  if (auto found = column_by_name(file, axis.name, wanted.kind)) return *found;
  throw Failure({wanted.missing, {{"file", file.name}, {"axis", axis.name}, {"known", file.known()}}},
                csv_malformed);
}

}  // namespace

MotionSignals motion_signals(RecordingFile const& file, MovedAxis const& axis, MotionColumns const& columns,
                             PositionUnits const& units) {
  std::array const chosen{chosen_column(file, axis.place,
                                        {.object = Object::actual_position,
                                         .kind = InputKind::position,
                                         .option = "--actual",
                                         .missing = says::which_actual},
                                        columns.actual),
                          chosen_column(file, axis.place,
                                        {.object = Object::torque,
                                         .kind = InputKind::force,
                                         .option = "--force",
                                         .missing = says::which_force},
                                        columns.force)};
  auto pair = recorded_pair(file, chosen, axis.cycle_ms);
  auto& position = pair.signals.signals[0];
  auto const scale = column_scale(file, chosen[0], units, axis.configured, position, {});
  position = positions(std::move(position), scale, scale.thousandths);
  if (auto const range = modulo_range(axis.configured)) {
    comparison::unwind(position, {}, *range / scale.thousandths);
  }
  auto const& force = file.recording.channels[chosen[1].channel];
  auto const force_scale = shown_scale(file, chosen[1], units.numbers);
  bool const is_rotary = axis.is_rotary();
  constexpr double thousandth_degree = std::numbers::pi / 180 / 1000, micrometre = 1e-6;
  double const unit = scale.thousandths * (is_rotary ? thousandth_degree : micrometre);
  MotionSignals found{
      .record = {.position = position.values(), .force = pair.signals.signals[1].values()},
      .sample_time_ms = pair.sample_time_ms,
      .is_unit_guessed = scale.is_guessed,
      .force = force_unit_of(named_unit(force)),
      .mapping = {mapped_column(file, chosen[0], scale, is_rotary), mapped_column(file, chosen[1])}};
  for (double& value : found.record.position) value *= unit;
  for (double& value : found.record.force) {
    value = (force_scale.factor * value + force_scale.offset) * found.force.factor;
  }
  found.mapping[1].scaling = force_scale.scaling;
  found.mapping[1].unit = repair_utf8(named_unit(force));
  return found;
}

}  // namespace axisc
