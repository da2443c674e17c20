#include "presentation/document.hpp"

#include "diagnostics/message.hpp"

#include <utility>

namespace axisc::presentation {

Field data(std::string key, Value value) {
  return {std::move(key), axisc::says::as_given, std::move(value), Audience::programs};
}

Field shown(Words label, Value value) {
  return {{}, std::move(label), std::move(value), Audience::people};
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

void add_row(Table& table, std::vector<Field> fields) {
  if (table.rows.empty()) {
    bool has_head = false;
    for (auto& [key, label, value, audience] : fields) {
      bool const is_head = !has_head && audience != Audience::programs;
      has_head = has_head || is_head;
      table.columns.push_back(
          {.key = std::move(key), .label = std::move(label), .audience = audience, .is_head = is_head});
    }
  }
  auto& row = table.rows.emplace_back();
  for (auto& field : fields) row.push_back(std::move(field.value));
}

}  // namespace axisc::presentation
