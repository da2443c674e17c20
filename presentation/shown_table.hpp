// The parts of a document that people and programs see, and tables as people see them.
#pragma once

#include "presentation/document.hpp"

namespace axisc::presentation {

[[nodiscard]] constexpr bool is_for_people(Audience audience) {
  return audience != Audience::programs;
}
[[nodiscard]] constexpr bool is_for_programs(Audience audience) {
  return audience != Audience::people;
}

/// A table as people see it: headings with units, cells as text.
struct ShownTable {
  std::vector<std::size_t> columns;  ///< which of the table's; those without any value are left out
  std::vector<std::string> headings;
  std::vector<bool> is_right;  ///< columns of numbers
  std::vector<bool> is_head;   ///< see Column
  std::vector<std::vector<std::string>> rows;
  std::string more;  ///< the number of rows not shown, as a sentence; empty for a whole table
};
[[nodiscard]] ShownTable shown_table(Table const& table, Language language, ForeignText foreign = nullptr);

}  // namespace axisc::presentation
