#include "schema/generator/table_writer.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/generator/perfect_hash.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

namespace axisc::schema::generator {
namespace {

std::string quoted(std::string const& text) {
  std::string literal = "\"";
  for (char const byte : text) {
    if (byte == '"' || byte == '\\') literal += '\\';
    literal += byte;
  }
  return literal + '"';
}

/// Of a text that is a decimal number as lists write them; everything else is read where it is asked for.
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

/// That reads as the same number again.
std::string shortest_text(double number) {
  std::array<char, 32> text{};
  auto const [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  std::string shortest(text.data(), end);
  if (shortest.find_first_of(".e") == std::string::npos) shortest += ".0";
  return shortest;
}

std::size_t index_count(ParameterRow const& row) {
  return static_cast<std::size_t>(std::count(row.name.begin(), row.name.end(), '['));
}

/// One concrete parameter.
struct Entry {
  std::string name;
  std::size_t parameter = 0;
};

/// `filter[].order` with 2 is `filter[2].order`.
std::string concrete_name(std::string const& pattern, std::array<std::uint32_t, 2> const& index) {
  std::string name;
  std::size_t position = 0;
  for (char const byte : pattern) {
    name += byte;
    if (byte == '[') name += std::to_string(index.at(position++));
  }
  return name;
}

std::vector<Entry> concrete_parameters(std::vector<ParameterRow> const& parameters) {
  std::vector<Entry> entries;
  for (std::size_t row = 0; row < parameters.size(); ++row) {
    auto const& array = parameters[row].array;
    std::uint32_t const first_size = std::max<std::uint32_t>(array[0], 1);
    std::uint32_t const second_size = std::max<std::uint32_t>(array[1], 1);
    for (std::uint32_t i = 0; i < first_size; ++i) {
      for (std::uint32_t j = 0; j < second_size; ++j) {
        entries.push_back({.name = concrete_name(parameters[row].name, {i, j}), .parameter = row});
      }
    }
  }
  return entries;
}

class TableWriter {
 public:
  explicit TableWriter(std::vector<ParameterRow> const& parameters)
      : parameters_(parameters), entries_(concrete_parameters(parameters)) {
    out_.precision(std::numeric_limits<double>::max_digits10);
  }

  std::string write() && {
    out_ << "// Generated from axis-parameters.json. Edit that file instead.\n\n";
    write_symbols();
    write_parameters();
    write_entries();
    write_hash();
    write_bare_names();
    write_numbers();
    write_words();
    return std::move(out_).str();
  }

 private:
  /// Many parameters share their words; each set is written once.
  void write_symbol_set(ParameterRow::Words const& symbols) {
    std::string text;
    for (auto const& [word, number] : symbols) {
      text += "    {" + quoted(word) + ", " + (number ? std::to_string(*number) : "std::nullopt") + "},\n";
    }
    auto const [known, is_new] = symbol_sets_.emplace(text, "symbols_" + std::to_string(symbol_sets_.size()));
    if (is_new && !symbols.empty()) {
      out_ << "constexpr Symbol " << known->second << "[] = {\n" << text << "};\n";
    }
    set_names_.push_back(symbols.empty() ? "{}" : known->second);
  }

  void write_symbols() {
    for (ParameterRow const& parameter : parameters_) {
      write_symbol_set(parameter.symbols);
      write_symbol_set(parameter.number_names);
    }
  }

  void write_limit(char const* member, Limit const& limit) {
    out_ << "." << member << " = ";
    if (limit.kind == Limit::Kind::none) {
      out_ << "{}, ";
      return;
    }
    out_ << "{.number = " << limit.number << ", .p_axis = " << limit.p_axis
         << ", .kind = Limit::Kind::" << (limit.kind == Limit::Kind::number ? "number" : "parameter")
         << ", .open = " << (limit.open ? "true" : "false") << "}, ";
  }

  void write_text(char const* member, std::string const& text) {
    out_ << ", ." << member << " = " << quoted(text);
  }

  void write_parameters() {
    out_ << "\nconstexpr Parameter parameter_table[] = {\n";
    std::size_t first_slot = 0;
    for (std::size_t row = 0; row < parameters_.size(); ++row) first_slot += write_parameter(row, first_slot);
    out_ << "};\n";
  }

  /// Returns the number of slots of the row.
  std::size_t write_parameter(std::size_t row, std::size_t first_slot) {
    ParameterRow const& parameter = parameters_[row];
    auto const& array = parameter.array;
    std::size_t const slots = slots_of(array);
    out_ << "    {";
    write_limit("minimum", parameter.minimum);
    write_limit("maximum", parameter.maximum);
    out_ << ".symbols = " << set_names_[2 * row]
         << ", .type = DataType::" << ascii::lower_case(data_type_name(parameter.type))
         << ", .has_default = " << (parameter.default_text ? "true" : "false")
         << ", .p_axis = " << parameter.p_axis << ", .max_length = " << parameter.max_length
         << ", .first_slot = Slot{" << first_slot << "}, .slots = " << slots << ", .array = {" << array[0]
         << ", " << array[1] << "}";
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

  void write_entries() {
    std::vector<int> bytes;
    out_ << "\nconstexpr SlotRow slot_table[] = {\n";
    for (Entry const& entry : entries_) {
      out_ << "    {" << bytes.size() << ", " << entry.name.size() << ", ParameterId{" << entry.parameter
           << "}},  // " << entry.name << '\n';
      bytes.insert(bytes.end(), entry.name.begin(), entry.name.end());
    }
    out_ << "};\n\n// All names in sequence; a literal might be longer than compilers take.";
    write_values("char", "name_bytes", bytes);
  }

  void write_hash() {
    std::vector<std::string> names;
    for (Entry const& entry : entries_) names.push_back(entry.name);
    write_hash_tables("", "slot", names);
  }

  /// Three tables, whose names begin alike.
  void write_hash_tables(std::string const& beginning, char const* entry,
                         std::vector<std::string> const& names) {
    PerfectHash const hash = make_perfect_hash(names);
    out_ << "\nconstexpr HashGeometry " << beginning << "hash_geometry{.buckets = " << hash.geometry.buckets
         << ", .places = " << hash.geometry.places << "};\n";
    write_values("std::uint16_t", beginning + "displacement_table", hash.displacements);
    out_ << "\n// The " << entry << " of each place; that of a free one has another name.";
    write_values("std::uint16_t", beginning + "place_table", hash.entries);
  }

  template <typename Value>
  void write_values(char const* type, std::string const& name, std::vector<Value> const& values) {
    constexpr std::size_t values_in_line = 20;
    out_ << "\nconstexpr " << type << " " << name << "[] = {";
    for (std::size_t i = 0; i < values.size(); ++i) {
      out_ << (i % values_in_line == 0 ? "\n    " : " ") << values[i] << ",";
    }
    out_ << "\n};\n";
  }

  void write_bare_names() {
    std::vector<std::tuple<std::string, std::size_t, std::size_t>> bare;
    for (std::size_t row = 0; row < parameters_.size(); ++row) {
      bare.emplace_back(without_brackets(parameters_[row].name), index_count(parameters_[row]), row);
    }
    std::sort(bare.begin(), bare.end());
    out_ << "\n// By name without brackets, fewer indices first.\nconstexpr ParameterId bare_row_table[] = "
            "{\n";
    for (auto const& [name, indices, row] : bare) out_ << "    ParameterId{" << row << "},\n";
    out_ << "};\n\n// Each name, where its rows begin and how many they are.\nconstexpr BareName "
            "bare_name_table[] = {\n";
    std::vector<std::string> names;
    for (std::size_t first = 0, end = 0; first < bare.size(); first = end) {
      std::string const& name = names.emplace_back(std::get<0>(bare[first]));
      while (end < bare.size() && std::get<0>(bare[end]) == name) ++end;
      out_ << "    {" << quoted(name) << ", " << first << ", " << end - first << "},\n";
    }
    out_ << "};\n";
    write_hash_tables("bare_", "name", names);
  }

  void write_numbers() {
    std::map<std::uint16_t, std::vector<std::size_t>> rows_of_number;
    for (std::size_t row = 0; row < parameters_.size(); ++row) {
      if (parameters_[row].p_axis != 0) rows_of_number[parameters_[row].p_axis].push_back(row);
    }
    std::vector<std::size_t> starts{0};
    out_ << "\n// Rows by number; the rows of number n begin at number_start_table[n] and end where those of "
            "n + 1 begin.\n"
         << "constexpr ParameterId number_table[] = {\n";
    std::size_t count = 0;
    for (auto const& [number, rows] : rows_of_number) {
      starts.resize(number + 1U, count);
      for (std::size_t const row : rows) out_ << "    ParameterId{" << row << "},\n";
      count += rows.size();
      starts.push_back(count);
    }
    out_ << "};\n";
    write_values("std::uint16_t", "number_start_table", starts);
  }

  void write_words() {
    std::set<std::string> words;
    for (ParameterRow const& parameter : parameters_) {
      for (auto const& [word, number] : parameter.symbols) words.insert(word);
    }
    out_ << "\nconstexpr std::string_view word_table[] = {\n";
    for (std::string const& word : words) out_ << "    " << quoted(word) << ",\n";
    out_ << "};\n";
  }

  std::vector<ParameterRow> const& parameters_;
  std::vector<Entry> entries_;
  std::map<std::string, std::string> symbol_sets_;  ///< name of the table by its text
  std::vector<std::string> set_names_;              ///< symbols and number names of each row
  std::ostringstream out_;
};

}  // namespace

std::string write_tables(std::vector<ParameterRow> const& parameters) {
  return TableWriter(parameters).write();
}

}  // namespace axisc::schema::generator
