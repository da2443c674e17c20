#include "configuration/xml/xml_parameter.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/catalogue.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>
#include <vector>

namespace axisc::configuration {
namespace {

constexpr std::size_t digits_of_number = 5;

/// `P-AXIS-00016.1` as number and indices; none for a number of another kind of list, and for every other name.
struct NumberedName {
  std::uint16_t number = 0;
  std::vector<std::uint32_t> indices;
};

std::optional<std::uint32_t> decimal(std::string_view text) {
  std::uint32_t number = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<NumberedName> numbered_name(std::string_view name, ListKind kind) {
  std::string const prefix = number_prefix(kind) + "-";
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  auto const number = decimal(name.substr(0, digits_of_number));
  if (!number || name.size() < digits_of_number) return std::nullopt;
  NumberedName numbered{.number = static_cast<std::uint16_t>(*number), .indices = {}};
  name.remove_prefix(digits_of_number);
  while (!name.empty()) {
    if (name.front() != '.') return std::nullopt;
    std::size_t const end = std::min(name.find('.', 1), name.size());
    auto const index = decimal(name.substr(1, end - 1));
    if (!index) return std::nullopt;
    numbered.indices.push_back(*index);
    name.remove_prefix(end);
  }
  return numbered;
}

/// `gruppe[0].achse[1].bezeichnung` for `gruppe[].achse[].bezeichnung` and the index 1.
std::string with_indices(std::string_view pattern, std::size_t count,
                         std::vector<std::uint32_t> const& indices) {
  std::string name;
  std::size_t position = 0;
  for (char const letter : pattern) {
    name += letter;
    if (letter != '[') continue;
    std::size_t const given = position++ + indices.size();
    name += std::to_string(given < count ? 0 : indices[given - count]);
  }
  return name;
}

}  // namespace

bool is_numbered(std::string_view element) {
  constexpr std::string_view form = "P-AAAA-0";
  if (element.size() < form.size()) return false;
  return std::equal(form.begin(), form.end(), element.begin(), [](char expected, char letter) {
    if (expected == 'A') return ascii::is_letter(letter);
    if (expected == '0') return ascii::is_digit(letter);
    return ascii::upper_case(letter) == expected;
  });
}

std::optional<std::string> parameter_name(std::string_view element, ListKind kind) {
  auto const numbered = numbered_name(element, kind);
  if (!numbered) return std::nullopt;
  auto const catalogue = schema::Catalogue::of(kind);
  schema::Parameter const* fitting = nullptr;
  for (schema::ParameterId const id : catalogue.find_number(numbered->number)) {
    schema::Parameter const& row = catalogue.parameter(id);
    if (row.index_count() < numbered->indices.size()) continue;
    if (fitting == nullptr || row.index_count() < fitting->index_count()) fitting = &row;
  }
  if (fitting == nullptr) return std::nullopt;
  return with_indices(fitting->name, fitting->index_count(), numbered->indices);
}

}  // namespace axisc::configuration
