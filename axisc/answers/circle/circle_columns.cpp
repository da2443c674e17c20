#include "axisc/answers/circle/circle_columns.hpp"

#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recorded_positions.hpp"
#include "diagnostics/joined.hpp"

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
  if (take([&](std::size_t i) { return column_called(file, name(i) + " setpoint"); })) return found;
  for (auto const object :
       {Object::position_unfiltered, Object::position_filtered, Object::command_position}) {
    if (!take([&](std::size_t i) { return setpoint_column(machine, file, plane.at(i), object); })) continue;
    found.is_filtered = object != Object::position_unfiltered;
    break;
  }
  return found;
}

Plane recorded_plane(CircleMachine const& machine, RecordingFile const& file,
                     std::vector<AxisColumn> const& actuals, std::vector<Plane> planes) {
  std::erase_if(planes, [&](Plane const& plane) {
    return std::any_of(plane.begin(), plane.end(),
                       [&](std::size_t axis) { return !actual_column(machine, file, axis, actuals); });
  });
  if (planes.size() == 1) return planes.front();
  std::vector<std::string> names;
  for (auto const& plane : planes) {
    for (auto const axis : plane) {
      auto const& name = machine.machine.axes[axis].name;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  throw refusal(says::no_plane, file,
                {{"axes", names.empty() ? Wording("none", "keine") : Wording(joined(names))}});
}

}  // namespace axisc
