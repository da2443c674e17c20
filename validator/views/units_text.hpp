// Raw numbers of a list in the unit a person thinks in: mm, mm/s, °, ms, Hz.
#pragma once

#include "schema/catalogue.hpp"
#include "machine/machine.hpp"

#include <string>
#include <string_view>

namespace axisc::validator {

/// Unit of the raw number on an axis of that type; empty where it has none.
[[nodiscard]] std::string_view unit_of(schema::Parameter const& parameter, machine::AxisType type);

/// `raw` in the unit of a person: 12000 "us" is "12 ms", 5000 "0.1 um" is "0.5 mm". A unit that is not known stays as it
/// is, a number without unit alone.
[[nodiscard]] std::string physical(double raw, std::string_view unit);

/// True where that is another number than the raw one.
[[nodiscard]] bool is_scaled(std::string_view unit);

/// The unit of the raw number in print: "µm/s" for "um/s", "0.1 µm" for "0.1 um".
[[nodiscard]] std::string raw_unit_name(std::string_view unit);

}  // namespace axisc::validator
