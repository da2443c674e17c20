#include "schema/generator/table_writer.hpp"

#include "schema/generator/perfect_hash.hpp"
#include "schema/generator/row_writer.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace axisc::schema::generator {
namespace {

std::size_t index_count(ParameterRow const& row) {
  return static_cast<std::size_t>(std::count(row.name.begin(), row.name.end(), '['));
}

/// One concrete parameter.
struct Entry {
  std::string name;
  std::size_t parameter = 0;
};

/// `filter[].order` with 2 is `filter[2].order`.
std::string concrete_name(std::string const& pattern, Indices const& index) {
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
        entries.push_back({.name = concrete_name(parameters[row].name, {i, j, 0}), .parameter = row});
      }
    }
  }
  return entries;
}

class TableWriter {
 public:
  explicit TableWriter(std::vector<ParameterRow> const& parameters)
      : parameters_(parameters), entries_(concrete_parameters(parameters)) {}

  std::string write() && {
    out_ << "// Generated from axis-parameters.json. Edit that file instead.\n\n";
    RowWriter(out_, "", parameters_).write();
    write_entries();
    write_hash();
    write_bare_names();
    write_numbers();
    write_words();
    return std::move(out_).str();
  }

 private:
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
  std::ostringstream out_;
};

}  // namespace

std::string write_tables(std::vector<ParameterRow> const& parameters) {
  return TableWriter(parameters).write();
}

}  // namespace axisc::schema::generator
