// Lines that were meant for a parameter and do not set it.
#pragma once

#include "validator/values/line_values.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace axisc::validator {

/// A line that was meant for a parameter and does not set it: a broken line, a mistyped name. The intended
/// value is unknown then, so rules that need it have to stay silent.
struct LostAssignment {
  schema::Slot slot{};
  Span name;
  std::uint32_t line = 0;
  bool guessed =
      false;  ///< the name had to be guessed: counts only where the list does not set the parameter
};
[[nodiscard]] std::vector<LostAssignment> lost_assignments(SourceText const& source,
                                                           grammar::AxisList const& list,
                                                           LineValues const& line_values,
                                                           schema::Catalogue const& catalogue = {});

/// The families that become part of an image: `filter`, `filter_fir`, `vib_guard`, `lr_param.add_interface`,
/// `lr_param.improved_position_control`. `name` may be misspelt after its family.
[[nodiscard]] bool is_compiled_family(std::string_view name);
/// Also with a slip of the pen in the family, or its two words swapped.
[[nodiscard]] bool is_close_to_compiled_family(std::string_view name);

}  // namespace axisc::validator
