// What a machine file says about reports: the words of their cover.
#pragma once

#include "configuration/json_shape.hpp"
#include "configuration/located_text.hpp"
#include "diagnostics/source_text.hpp"

#include <optional>

namespace axisc::configuration {

/// The options of `axisc report` win.
struct MachineFileReport {
  std::optional<LocatedText> title, customer, author, date;
  std::optional<double> tolerance_mm;  ///< allowed axis error
};

/// Reads it from the machine file `sources[source]`, whose mistakes read_machine_file() reports; what is not
/// readable is left out.
[[nodiscard]] MachineFileReport read_report(SourceSet const& sources, SourceId source);

/// The shape of the key "report".
extern JsonShape const machine_file_report_shape;

/// Of names that people read.
extern JsonShape const visible_name_shape;

}  // namespace axisc::configuration
