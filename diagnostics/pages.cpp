#include "diagnostics/pages.hpp"

#include "diagnostics/page_table.hpp"

#include <algorithm>
#include <string_view>

namespace axisc {

std::string_view page(Code code, Language language) {
  auto const table = page_table();
  auto const found = std::lower_bound(table.begin(), table.end(), code,
                                      [](PageTexts const& row, Code wanted) { return row.code < wanted; });
  if (found == table.end() || found->code != code) return {};
  return language == Language::german ? found->german : found->english;
}

}  // namespace axisc
