#include "schema/descriptions/description.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <span>

namespace axisc::schema {
namespace {

struct TextRow {
  std::uint16_t literal;
  std::uint16_t begin;
  std::uint16_t size;
};

struct PageRow {
  TextRow english;
  TextRow german;
};

struct ValueRow {
  TextRow value;
  PageRow meaning;
};

struct DescriptionRow {
  PageRow what;
  PageRow detail;
  std::uint16_t first_value;
  std::uint16_t values;
  bool inferred;
  bool restart;
};

#include "description_tables.inc"

std::string_view text(TextRow const& row) {
  return {literals[row.literal] + row.begin, row.size};
}

Page page(PageRow const& row) {
  return {.english = text(row.english), .german = text(row.german)};
}

struct ManualRow {
  std::string_view beginning;  ///< of names
  Page section;
};

constexpr Page position_control{"Improved Position Control, section 4.2",
                                "Optimierte Lageregelung, Abschnitt 4.2"};

/// The first that fits counts.
constexpr std::array manuals = {
    ManualRow{"filter_fir.", {"FIR filters, section 6.2", "FIR-Filter, Abschnitt 6.2"}},
    ManualRow{"filter[", {"Axis filters, section 3.2", "Achsfilter, Abschnitt 3.2"}},
    ManualRow{"lr_param.add_interface.", {"Axis filters, section 3.3", "Achsfilter, Abschnitt 3.3"}},
    ManualRow{"lr_param.improved_position_control.", position_control},
    ManualRow{"antr.v_reso_", position_control},
    ManualRow{"antr.v_time_base", position_control},
    ManualRow{"getriebe[].multi_gain_", position_control},
};

}  // namespace

Page manual_section(Parameter const& parameter) {
  if (parameter.kind != ListKind::axis) return {};
  auto const found = std::find_if(manuals.begin(), manuals.end(), [&](ManualRow const& row) {
    return parameter.name.starts_with(row.beginning);
  });
  return found == manuals.end() ? Page{} : found->section;
}

Description description_of(Parameter const& parameter) {
  if (parameter.kind != ListKind::axis) return {};
  auto const rows = parameters();
  // Rows of schema files lie elsewhere.
  bool const is_built_in =
      std::greater_equal<>{}(&parameter, rows.data()) && std::less<>{}(&parameter, rows.data() + rows.size());
  auto const found = is_built_in ? rows.begin() + (&parameter - rows.data())
                                 : std::find_if(rows.begin(), rows.end(), [&](Parameter const& row) {
                                     return row.name == parameter.name;
                                   });
  if (found == rows.end()) return {};
  DescriptionRow const& row = description_table[std::distance(rows.begin(), found)];
  Description description{.what = page(row.what),
                          .detail = page(row.detail),
                          .values = {},
                          .inferred = row.inferred,
                          .restart = row.restart};
  for (ValueRow const& value : std::span(value_table).subspan(row.first_value, row.values)) {
    description.values.push_back({.value = text(value.value), .meaning = page(value.meaning)});
  }
  return description;
}

}  // namespace axisc::schema
