// Numbers in columns, as measuring programs write them.
#pragma once

#include "analysis/recordings/text_lines.hpp"
#include "analysis/tuning/identification/measurement.hpp"

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace axisc::tuning {

struct NumberTable {
  std::vector<std::string> names;            ///< "1", "2", … where no line names the columns
  std::vector<std::vector<double>> columns;  ///< all of one size, at least 2
  std::vector<std::size_t> lines;            ///< of the rows, from 1
};

[[nodiscard]] std::variant<NumberTable, BadMeasurement> read_number_table(recordings::ByteSource source);

}  // namespace axisc::tuning
