#include "validator/views/units_text.hpp"

#include "diagnostics/format_number.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/value.hpp"

#include <array>

namespace axisc::validator {
namespace {

struct PrintedUnit {
  std::string_view raw;
  double factor;
  std::string_view name;
};

constexpr std::array<PrintedUnit, 24> printed_units = {{
    {.raw = "0.1 um", .factor = 1e-4, .name = "mm"},
    {.raw = "um", .factor = 1e-3, .name = "mm"},
    {.raw = "1e-4 deg", .factor = 1e-4, .name = "°"},
    {.raw = "1e-3 deg", .factor = 1e-3, .name = "°"},
    {.raw = "deg", .factor = 1, .name = "°"},
    {.raw = "us", .factor = 1e-3, .name = "ms"},
    {.raw = "um/s", .factor = 1e-3, .name = "mm/s"},
    {.raw = "1e-3 deg/s", .factor = 1e-3, .name = "°/s"},
    {.raw = "mm/s^2", .factor = 1, .name = "mm/s²"},
    {.raw = "deg/s^2", .factor = 1, .name = "°/s²"},
    {.raw = "mm/s^3", .factor = 1, .name = "mm/s³"},
    {.raw = "deg/s^3", .factor = 1, .name = "°/s³"},
    {.raw = "m/s^3", .factor = 1, .name = "m/s³"},
    {.raw = "1e3 deg/s^3", .factor = 1e3, .name = "°/s³"},
    {.raw = "0.1 %", .factor = 0.1, .name = "%"},
    {.raw = "0.01/s", .factor = 0.01, .name = "1/s"},
    {.raw = "0.1 um/rev", .factor = 1e-4, .name = "mm/rev"},
    {.raw = "1e-4 deg/rev", .factor = 1e-4, .name = "°/rev"},
    {.raw = "um/m", .factor = 1, .name = "µm/m"},
    {.raw = "s/deg^2", .factor = 1, .name = "s/°²"},
    {.raw = "kg m^2", .factor = 1, .name = "kg·m²"},
    {.raw = "N m", .factor = 1, .name = "N·m"},
    {.raw = "cycle", .factor = 1, .name = "T"},
    {.raw = "increment", .factor = 1, .name = "inc"},
}};

PrintedUnit row_of(std::string_view unit) {
  for (PrintedUnit const& row : printed_units) {
    if (row.raw == unit) return row;
  }
  return {.raw = unit, .factor = 1, .name = unit};
}

}  // namespace

std::string_view unit_of(schema::Parameter const& parameter, machine::AxisType type) {
  return type == machine::AxisType::translatory ? parameter.unit_translatory : parameter.unit_rotary;
}

Wording physical(double raw, std::string_view unit) {
  PrintedUnit const row = row_of(unit);
  Wording text = format_rounded(raw * row.factor, 12);
  if (!row.name.empty()) text += " " + std::string(row.name);
  return text;
}

bool is_scaled(std::string_view unit) {
  return row_of(unit).factor != 1;
}

std::string raw_unit_name(std::string_view unit) {
  struct Replacement {
    std::string_view plain;
    std::string_view printed;
  };
  constexpr std::array<Replacement, 5> replacements = {{
      {.plain = "um", .printed = "µm"},
      {.plain = "us", .printed = "µs"},
      {.plain = "deg", .printed = "°"},
      {.plain = "^2", .printed = "²"},
      {.plain = "^3", .printed = "³"},
  }};
  std::string text(unit);
  for (Replacement const& replacement : replacements) {
    std::size_t const at = text.find(replacement.plain);
    if (at != std::string::npos) text.replace(at, replacement.plain.size(), replacement.printed);
  }
  return text;
}

Wording unit_name(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> powers = {
      {{"1e-4 ", "0.0001 "}, {"1e-3 ", "0.001 "}, {"1e3 ", "1000 "}}};
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> german_words = {
      {{"cycle", "Zyklen"}, {"increment", "Inkremente"}, {"rev", "Umdrehung"}}};
  auto text = raw_unit_name(unit);
  for (auto const& [power, digits] : powers) {
    if (text.starts_with(power)) text.replace(0, power.size(), digits);
  }
  auto german = Wording::number(text).in(Language::german);
  for (auto const& [word, translated] : german_words) {
    if (auto const at = german.find(word); at != std::string::npos) {
      german.replace(at, word.size(), translated);
    }
  }
  return {text, german};
}

Wording number_name(schema::Parameter const& parameter, schema::Symbol const& name) {
  std::string const english(name.word);
  std::string const number = name.number ? std::to_string(*name.number) : std::string();
  for (auto const& [value, meaning] : schema::description_of(parameter).values) {
    if (value == number) return {english, std::string(meaning.in(Language::german))};
  }
  return english;
}

std::string default_text(schema::Parameter const& parameter) {
  auto const value = schema::default_value(parameter);
  bool const is_number = value && value->text.empty() && !schema::is_bit_mask(parameter) &&
                         parameter.type != schema::DataType::string;
  return is_number ? format_exact(value->number) : std::string(parameter.default_text);
}

}  // namespace axisc::validator
