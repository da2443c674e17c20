#include "presentation/document.hpp"

#include "diagnostics/message.hpp"

#include <utility>

namespace axisc::presentation {

Field data(std::string key, Value value, std::string member) {
  return {.key = std::move(key),
          .label = axisc::says::as_given,
          .value = std::move(value),
          .audience = Audience::programs,
          .member = std::move(member)};
}

Field shown(Words label, Value value) {
  return {.key = {}, .label = std::move(label), .value = std::move(value), .audience = Audience::people};
}

Column column(std::string key, Words label, Unit unit, std::string member) {
  return {.key = std::move(key), .label = std::move(label), .unit = unit, .member = std::move(member)};
}

Column head_column(std::string key, Words label, Unit unit) {
  return {.key = std::move(key), .label = std::move(label), .unit = unit, .is_head = true};
}

Column data_column(std::string key, std::string member) {
  return {.key = std::move(key),
          .label = axisc::says::as_given,
          .member = std::move(member),
          .audience = Audience::programs};
}

std::vector<Column> data_columns(std::vector<std::string> keys) {
  std::vector<Column> columns;
  columns.reserve(keys.size());
  for (auto& key : keys) columns.push_back(data_column(std::move(key)));
  return columns;
}

Section data_section(std::string key, std::vector<Field> fields) {
  return {.key = std::move(key),
          .title = {},
          .blocks = {Facts{std::move(fields)}},
          .audience = Audience::programs};
}

Section part(Words title, std::vector<Block> blocks, Audience audience) {
  return {.key = {}, .title = std::move(title), .blocks = std::move(blocks), .audience = audience};
}

Section folded(Words title, std::vector<Block> blocks) {
  auto section = part(std::move(title), std::move(blocks));
  section.is_folded = true;
  return section;
}

void add_row(Table& table, std::vector<Field> fields) {
  if (table.rows.empty()) {
    bool has_head = false;
    for (auto& [key, label, value, audience, member] : fields) {
      bool const is_head = !has_head && audience != Audience::programs;
      has_head = has_head || is_head;
      table.columns.push_back({.key = std::move(key),
                               .label = std::move(label),
                               .member = std::move(member),
                               .audience = audience,
                               .is_head = is_head});
    }
  }
  auto& row = table.rows.emplace_back();
  for (auto& field : fields) row.push_back(std::move(field.value));
}

}  // namespace axisc::presentation
