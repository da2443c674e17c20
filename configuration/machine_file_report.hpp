// What a machine file says about reports: the words of their cover.
#pragma once

#include "configuration/json_shape.hpp"
#include "configuration/located_text.hpp"

#include <optional>

namespace axisc::configuration {

/// Options of `axisc report` take precedence.
struct MachineFileReport {
  std::optional<LocatedText> title, customer, author, date;
  std::optional<double> tolerance_mm;  ///< allowed axis error
};

/// The shape of the key "report".
extern JsonShape const machine_file_report_shape;

/// Of names that people read.
extern JsonShape const visible_name_shape;

}  // namespace axisc::configuration
