#include "lists/readers.hpp"

#include <charconv>
#include <ini.h>

#include <nlohmann/json.hpp>

namespace axisc::bench {
namespace {

/// What inih calls for every line; everything is text there.
int take(void* table_of_file, char const* /*section*/, char const* name, char const* value) {
  auto& table = *static_cast<EntryTable*>(table_of_file);
  schema::Parameter const* const parameter = table.open(name, 0);
  if (parameter == nullptr) return 1;
  std::string_view const text(value);
  bool const hexadecimal = text.substr(0, 2) == "0x";
  double number = 0;
  if (hexadecimal) {
    std::uint64_t magnitude = 0;
    std::from_chars(text.data() + 2, text.data() + text.size(), magnitude, 16);
    number = static_cast<double>(magnitude);
    table.number(*parameter, number);
  } else if (std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc{}) {
    table.number(*parameter, number);
  } else {
    table.word(*parameter, text);
  }
  return 1;
}

}  // namespace

void read_with_inih(std::string const& ini, EntryTable& table) {
  table.clear();
  ini_parse_string(ini.c_str(), take, &table);
}

void read_with_nlohmann(std::string const& json, EntryTable& table) {
  table.clear();
  auto const document = nlohmann::json::parse(json);
  for (auto const& [name, value] : document.items()) {
    schema::Parameter const* const parameter = table.open(name, 0);
    if (parameter == nullptr) continue;
    if (value.is_boolean()) {
      table.truth(*parameter, value.get<bool>());
    } else if (value.is_number()) {
      table.number(*parameter, value.get<double>());
    } else {
      table.word(*parameter, value.get_ref<std::string const&>());
    }
  }
}

}  // namespace axisc::bench
