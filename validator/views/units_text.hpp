// Raw numbers of a list in usual units: mm, mm/s, °, ms, Hz.
#pragma once

#include "configuration/machine/machine.hpp"
#include "diagnostics/wording.hpp"
#include "schema/catalogue.hpp"

#include <string>
#include <string_view>

namespace axisc::validator {

/// Unit of the raw number on an axis of that type; empty where it has none.
[[nodiscard]] std::string_view unit_of(schema::Parameter const& parameter, machine::AxisType type);

/// `raw` in its usual unit: 12000 "us" is "12 ms", 5000 "0.1 um" is "0.5 mm". Unknown units are kept; a
/// number without unit is printed alone.
[[nodiscard]] Wording physical(double raw, std::string_view unit);

/// True if physical() prints a number different from the raw one.
[[nodiscard]] bool is_scaled(std::string_view unit);

/// The unit of the raw number in print: "µm/s" for "um/s", "0.1 µm" for "0.1 um".
[[nodiscard]] std::string raw_unit_name(std::string_view unit);

/// One of the parameter's number_names; in German as the descriptions have it.
[[nodiscard]] Wording number_name(schema::Parameter const& parameter, schema::Symbol const& name);

/// The default in plain numbers: 30 for 3.000000e+001, 4 for 0x0004; empty if there is none.
[[nodiscard]] std::string default_text(schema::Parameter const& parameter);

}  // namespace axisc::validator
