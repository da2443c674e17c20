#include "validator/views/drive.hpp"

#include "validator/views/units_text.hpp"

#include <algorithm>
#include <string>

namespace axisc::validator {
namespace {

template <typename Matches>
machine::DriveType const* find_drive(Matches matches) {
  auto const* const found = std::find_if(machine::drive_types.begin(), machine::drive_types.end(), matches);
  return found == machine::drive_types.end() ? nullptr : found;
}

}  // namespace

machine::DriveType const* drive_of(LoadedAxis const& axis) {
  if (axis.drive) {
    return find_drive([&](machine::DriveType const& drive) { return drive.word == axis.drive->text; });
  }
  EffectiveValue const& type = axis.merged.values.at("kenngr.antr_typ");
  if (type.unusable) return nullptr;
  return find_drive([&](machine::DriveType const& drive) { return drive.number == type.value.number; });
}

machine::DriveType const* stated_drive(LoadedAxis const& axis) {
  return axis.drive || axis.merged.values.at("kenngr.antr_typ").set() ? drive_of(axis) : nullptr;
}

Wording drive_name(machine::DriveType const& drive) {
  return number_name(row_at("kenngr.antr_typ"),
                     {.word = drive.word, .number = static_cast<int>(drive.number)});
}

machine::PositionController position_controller(LoadedAxis const& axis) {
  if (axis.position_control != machine::PositionController::unknown) return axis.position_control;
  EffectiveValue const& mode = axis.merged.values.at("antr.operation_mode");
  if (mode.unusable || is_open_loop(mode)) return machine::PositionController::unknown;
  std::string_view const word = mode.value.text;
  if (word == "CNC_POSITION_CONTROL") return machine::PositionController::cnc;
  if (word == "DRIVE_POSITION_CONTROL" || word == "DSC_POSITION_CONTROL") {
    return machine::PositionController::drive;
  }
  machine::DriveType const* const drive = drive_of(axis);
  if (drive == nullptr) return machine::PositionController::unknown;
  return drive->digital ? machine::PositionController::drive : machine::PositionController::cnc;
}

bool is_open_loop(EffectiveValue const& operation_mode) {
  constexpr std::string_view open = "OPEN_POSITION_LOOP";
  return !operation_mode.unusable && operation_mode.value.text.starts_with(open);
}

}  // namespace axisc::validator
