#include "schema/parameter_row.hpp"

#include <algorithm>

namespace axisc::schema {
namespace {

ParameterRow::Words words_of(std::span<Symbol const> symbols) {
  ParameterRow::Words words;
  for (Symbol const& symbol : symbols) words.emplace_back(symbol.word, symbol.number);
  return words;
}

}  // namespace

std::size_t slots_of(ArraySizes const& array) {
  std::size_t slots = 1;
  for (std::uint16_t const size : array) slots *= std::max<std::size_t>(size, 1);
  return slots;
}

ParameterRow ParameterRow::from(Parameter const& parameter) {
  ParameterRow row;
  row.name = parameter.name;
  row.p_axis = parameter.p_axis;
  row.type = parameter.type;
  if (parameter.has_default) row.default_text = parameter.default_text;
  row.array = parameter.array;
  row.is_flags = parameter.is_flags;
  row.kind = parameter.kind;
  row.unit_translatory = parameter.unit_translatory;
  row.unit_rotary = parameter.unit_rotary;
  row.minimum = parameter.minimum;
  row.maximum = parameter.maximum;
  row.symbols = words_of(parameter.symbols);
  row.number_names = words_of(parameter.number_names);
  row.max_length = parameter.max_length;
  row.axis_types = parameter.axis_types;
  row.former_name = parameter.former_name;
  row.since = parameter.since;
  return row;
}

Parameter ParameterRow::view() const {
  return {.minimum = minimum,
          .maximum = maximum,
          .symbols = {},
          .type = type,
          .has_default = default_text.has_value(),
          .p_axis = p_axis,
          .max_length = max_length,
          .is_flags = is_flags,
          .kind = kind,
          .first_slot = {},
          .slots = static_cast<std::uint32_t>(slots_of(array)),
          .array = array,
          .name = name,
          .default_text = default_text ? std::string_view(*default_text) : std::string_view(),
          .unit_translatory = unit_translatory,
          .unit_rotary = unit_rotary,
          .number_names = {},
          .axis_types = axis_types,
          .former_name = former_name,
          .since = since};
}

}  // namespace axisc::schema
