// The objects of an ISG kernel in TwinCAT that a scope records, by port, index group and index offset.
//
//   channel groups  0x121300 + channel, offset + 0x10000 times the axis' index in the channel, from 1 (manual
//                   "Axis filters")
//   axis groups     0x1202xx and 0x1203xx, offset + 0x10000 times the number of the axis
//
// Bit 0x100000 of a group says that it is addressed logically; it is not compared. Group and offset decide
// together: 0x1C of 0x1203xx is something else than 0x1C of 0x1213xx.
#pragma once

#include "analysis/recordings/recording.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace axisc::recordings {

enum class Object : std::uint8_t {
  position_unfiltered,  ///< command position before the filters
  position_filtered,    ///< after them
  physical_axis,        ///< the number of the axis that is moved
  velocity,             ///< in the format of the drive
  additive_velocity,    ///< what Improved Position Control and interface filters add to it
  backlash_acting,
  backlash_configured,
  command_position,  ///< of the position controller
  actual_position,
  torque,  ///< by name alone: its index is not documented
};

enum class ObjectUnit : std::uint8_t {
  none,
  position,              ///< 0.1 µm or 0.0001°
  increments,            ///< of the measuring system
  increments_per_cycle,  ///< of the drive
  of_the_drive,          ///< as the drive has it
};

struct ObjectRow {
  std::string_view word;     ///< for programs, and in names of a template: "X filtered"
  std::string_view symbol;   ///< the control's own name; may be empty
  std::uint32_t group = 0;   ///< of channel 0; 0: by name alone
  std::uint32_t offset = 0;  ///< of axis 0
  std::uint16_t port = 0;
  bool is_of_channel = false;
  std::string_view data_type;  ///< Scope's word
  ObjectUnit unit = ObjectUnit::none;
};

/// By Object.
[[nodiscard]] std::span<ObjectRow const> object_rows();
[[nodiscard]] ObjectRow const& row_of(Object object);

/// What a channel is.
struct RecognisedObject {
  Object object = Object::position_unfiltered;
  bool is_by_index = false;   ///< else by the control's name of the object, which says no axis
  std::uint32_t channel = 0;  ///< of a channel group, from 1
  std::uint32_t axis = 0;     ///< index in the channel, or number of the axis
};

/// None for other objects, such as variables of a PLC.
[[nodiscard]] std::optional<RecognisedObject> object_of(Channel const& channel);

/// "X filtered": the name that a template gives to the object of an axis.
[[nodiscard]] std::string template_name(std::string_view axis, Object object);

/// The name without a unit in brackets and without what a scope appends to a copy: "x" of "x [mm]" and of
/// "x (1)".
[[nodiscard]] std::string_view plain_name(std::string_view name);
/// "mm" of "x [mm]"; empty where the name ends without brackets.
[[nodiscard]] std::string_view unit_in_brackets(std::string_view name);

}  // namespace axisc::recordings
