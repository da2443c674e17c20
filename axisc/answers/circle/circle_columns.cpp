#include "axisc/answers/circle/circle_columns.hpp"

#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence no_actual{
    "{file} has no column for the actual position of axis {axis}; name it with --actual {axis}=COLUMN; there "
    "are {known}",
    "{file} hat keine Spalte für die Istposition der Achse {axis}; sie mit --actual {axis}=SPALTE nennen; "
    "vorhanden sind {known}"};
constexpr Sentence half_setpoint{
    "{file} has a setpoint of axis {axis}, and none of axis {other}; name it with --setpoint {other}=COLUMN; "
    "there are {known}",
    "{file} hat einen Sollwert der Achse {axis}, aber keinen der Achse {other}; ihn mit --setpoint "
    "{other}=SPALTE nennen; vorhanden sind {known}"};
constexpr Sentence no_plane{
    "{file} has actual positions of these linear axes: {axes}; name the two of the circle with --plane, and "
    "with --actual AXIS=COLUMN what is not recognised; there are {known}",
    "{file} hat Istpositionen dieser Linearachsen: {axes}; die beiden des Kreises mit --plane nennen und mit "
    "--actual ACHSE=SPALTE, was nicht erkannt wird; vorhanden sind {known}"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Object;

Failure refusal(SentenceRef sentence, RecordingFile const& file, std::vector<Argument> arguments) {
  arguments.push_back({"file", file.name});
  arguments.push_back({"known", file.known()});
  return Failure({sentence, std::move(arguments)}, csv_malformed);
}

std::optional<ChosenColumn> named(RecordingFile const& file, std::string const& axis,
                                  std::vector<AxisColumn> const& columns) {
  for (auto const& each : columns) {
    if (each.axis == axis) return named_column(file, each.column);
  }
  return std::nullopt;
}

/// "X setpoint".
std::optional<ChosenColumn> called_setpoint(RecordingFile const& file, std::string const& axis) {
  auto const& channels = file.recording.channels;
  auto const found = std::find_if(channels.begin(), channels.end(), [&](recordings::Channel const& channel) {
    return ascii::equal_ignoring_case(recordings::plain_name(channel.name), axis + " setpoint");
  });
  if (found == channels.end()) return std::nullopt;
  return ChosenColumn{.channel = static_cast<std::size_t>(found - channels.begin()), .by = FoundBy::name};
}

std::optional<ChosenColumn> actual_column(CircleMachine const& machine, RecordingFile const& file,
                                          std::size_t axis, std::vector<AxisColumn> const& actuals) {
  auto const& name = machine.machine.axes[axis].name;
  if (auto column = named(file, name, actuals)) return column;
  return find_column(file, axis_place(machine.machine, axis, names_machine(machine.path)),
                     Object::actual_position, "--actual " + name + "=");
}

std::optional<ChosenColumn> setpoint_column(CircleMachine const& machine, RecordingFile const& file,
                                            std::size_t axis, Object object) {
  auto const& name = machine.machine.axes[axis].name;
  return find_column(file, axis_place(machine.machine, axis, names_machine(machine.path)), object,
                     "--setpoint " + name + "=");
}

}  // namespace

CircleColumns circle_columns(CircleMachine const& machine, Plane const& plane, RecordingFile const& file,
                             std::vector<AxisColumn> const& setpoints,
                             std::vector<AxisColumn> const& actuals) {
  CircleColumns found;
  auto const name = [&](std::size_t i) { return machine.machine.axes[plane.at(i)].name; };
  for (std::size_t i = 0; i < plane.size(); ++i) {
    auto const column = actual_column(machine, file, plane.at(i), actuals);
    if (!column) throw refusal(says::no_actual, file, {{"axis", name(i)}});
    found.actuals.push_back(*column);
  }
  auto const take = [&](auto const& column_of) {
    auto const first = column_of(0);
    auto const second = column_of(1);
    if (!first && !second) return false;
    if (!first || !second) {
      throw refusal(says::half_setpoint, file,
                    {{"axis", name(first ? 0 : 1)}, {"other", name(first ? 1 : 0)}});
    }
    found.setpoints = {*first, *second};
    return true;
  };
  if (take([&](std::size_t i) { return named(file, name(i), setpoints); })) return found;
  if (take([&](std::size_t i) { return called_setpoint(file, name(i)); })) return found;
  for (auto const object :
       {Object::position_unfiltered, Object::position_filtered, Object::command_position}) {
    if (!take([&](std::size_t i) { return setpoint_column(machine, file, plane.at(i), object); })) continue;
    found.is_filtered = object != Object::position_unfiltered;
    break;
  }
  return found;
}

Plane recorded_plane(CircleMachine const& machine, RecordingFile const& file,
                     std::vector<AxisColumn> const& actuals) {
  std::vector<std::size_t> axes;
  Wording names;
  for (std::size_t i = 0; i < machine.machine.axes.size(); ++i) {
    auto const& axis = machine.machine.axes[i];
    if (axis.type != machine::AxisType::translatory || !actual_column(machine, file, i, actuals)) continue;
    axes.push_back(i);
    names += (axes.size() == 1 ? "" : ", ") + axis.name;
  }
  if (axes.size() == 2) return {axes[0], axes[1]};
  if (axes.empty()) names = Wording("none", "keine");
  throw refusal(says::no_plane, file, {{"axes", names}});
}

}  // namespace axisc
