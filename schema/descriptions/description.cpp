#include "schema/descriptions/description.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

}  // namespace

Description description_of(Parameter const& parameter) {
  if (parameter.kind != ListKind::axis) return {};
  auto const rows = parameters();
  auto const found = std::find_if(rows.begin(), rows.end(),
                                  [&](Parameter const& row) { return row.name == parameter.name; });
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
