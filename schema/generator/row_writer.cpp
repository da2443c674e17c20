#include "schema/generator/row_writer.hpp"

#include "diagnostics/ascii.hpp"

#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

namespace axisc::schema::generator {
namespace {

/// The number of a text that is a decimal number as lists write them; other texts are read when they are
/// used.
std::optional<double> decimal_number(std::string const& text) {
  std::string_view digits = text;
  if (digits.starts_with('-')) digits.remove_prefix(1);
  if (digits.empty() || ascii::has_leading_zero(digits) ||
      digits.find_first_not_of("0123456789.eE+-") != std::string_view::npos) {
    return std::nullopt;
  }
  double number = 0;
  auto const [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A literal that reads back as the same number.
std::string shortest_text(double number) {
  std::array<char, 32> text{};
  auto const [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  std::string shortest(text.data(), end);
  if (shortest.find_first_of(".e") == std::string::npos) shortest += ".0";
  return shortest;
}

}  // namespace

std::string quoted(std::string const& text) {
  if (text.find('"') != std::string::npos) return "R\"(" + text + ")\"";
  std::string literal = "\"";
  for (char const byte : text) {
    if (byte == '\\') literal += '\\';
    literal += byte;
  }
  return literal + '"';
}

void RowWriter::write() {
  auto const precision = out_.precision(std::numeric_limits<double>::max_digits10);
  for (ParameterRow const& parameter : rows_) {
    write_symbol_set(parameter.symbols);
    write_symbol_set(parameter.number_names);
  }
  out_ << "\nconstexpr Parameter " << prefix_ << "parameter_table[] = {\n";
  std::size_t first_slot = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) first_slot += write_parameter(row, first_slot);
  out_ << "};\n";
  out_.precision(precision);
}

/// Many parameters share their words; each set is written once.
void RowWriter::write_symbol_set(ParameterRow::Words const& symbols) {
  std::string text;
  for (auto const& [word, number] : symbols) {
    text += "    {" + quoted(word) + ", " + (number ? std::to_string(*number) : "std::nullopt") + "},\n";
  }
  auto const [known, is_new] =
      symbol_sets_.emplace(text, prefix_ + "symbols_" + std::to_string(symbol_sets_.size()));
  if (is_new && !symbols.empty()) {
    out_ << "constexpr Symbol " << known->second << "[] = {\n" << text << "};\n";
  }
  set_names_.push_back(symbols.empty() ? "{}" : known->second);
}

void RowWriter::write_limit(char const* member, Limit const& limit) {
  out_ << "." << member << " = ";
  if (limit.kind == Limit::Kind::none) {
    out_ << "{}, ";
    return;
  }
  out_ << "{.number = " << limit.number << ", .p_axis = " << limit.p_axis
       << ", .kind = Limit::Kind::" << (limit.kind == Limit::Kind::number ? "number" : "parameter")
       << ", .open = " << (limit.open ? "true" : "false") << "}, ";
}

void RowWriter::write_text(char const* member, std::string const& text) {
  out_ << ", ." << member << " = " << quoted(text);
}

std::size_t RowWriter::write_parameter(std::size_t row, std::size_t first_slot) {
  ParameterRow const& parameter = rows_[row];
  auto const& array = parameter.array;
  std::size_t const slots = slots_of(array);
  out_ << "    {";
  write_limit("minimum", parameter.minimum);
  write_limit("maximum", parameter.maximum);
  out_ << ".symbols = " << set_names_[2 * row]
       << ", .type = DataType::" << ascii::lower_case(data_type_name(parameter.type))
       << ", .has_default = " << (parameter.default_text ? "true" : "false")
       << ", .p_axis = " << parameter.p_axis << ", .max_length = " << parameter.max_length
       << ", .is_flags = " << (parameter.is_flags ? "true" : "false")
       << ", .kind = ListKind::" << row_of(parameter.kind).word << ", .first_slot = Slot{" << first_slot
       << "}, .slots = " << slots << ", .array = {" << array[0] << ", " << array[1] << ", " << array[2]
       << "}";
  write_text("name", parameter.name);
  write_text("default_text", parameter.default_text.value_or(""));
  write_text("unit_translatory", parameter.unit_translatory);
  write_text("unit_rotary", parameter.unit_rotary);
  out_ << ", .number_names = " << set_names_[2 * row + 1];
  write_text("axis_types", parameter.axis_types);
  write_text("former_name", parameter.former_name);
  write_text("since", parameter.since);
  if (auto const number = decimal_number(parameter.default_text.value_or(""))) {
    out_ << ", .default_number = " << shortest_text(*number);
  }
  out_ << "},\n";
  return slots;
}

}  // namespace axisc::schema::generator
