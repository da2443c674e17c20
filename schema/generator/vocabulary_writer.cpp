#include "schema/generator/table_writer.hpp"
#include "schema/vocabulary.hpp"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::schema::generator {
namespace {

template <typename Values, typename Write>
void write_array(std::ostream& out, std::string_view type, std::string_view name, Values const& values,
                 Write write) {
  constexpr std::size_t values_in_line = 10;
  out << "\nconstexpr " << type << ' ' << name << "[] = {";
  std::size_t count = 0;
  for (auto const& value : values) {
    out << (count++ % values_in_line == 0 ? "\n    " : " ");
    write(value);
    out << ',';
  }
  out << "\n};\n";
}

}  // namespace

std::string write_vocabulary(std::vector<ParameterRow> const& parameters) {
  std::vector<std::string> patterns;
  patterns.reserve(parameters.size());
  for (ParameterRow const& parameter : parameters) patterns.push_back(parameter.name);
  VocabularyTables const tables(patterns);

  std::ostringstream out;
  out << "// Generated from axis-parameters.json. Edit that file instead.\n";
  // Names and parts hold neither quotes nor backslashes.
  auto const texts = [&out](std::string_view name, auto const& values) {
    write_array(out, "std::string_view", name, values,
                [&out](auto const& text) { out << '"' << text << '"'; });
  };
  auto const numbers = [&out](std::string_view name, auto const& values) {
    write_array(out, "std::uint32_t", name, values, [&out](std::uint32_t number) { out << number; });
  };
  auto const letters = [&out](std::string_view name, auto const& values) {
    write_array(out, "Letters", name, values, [&out](Letters set) { out << set << 'U'; });
  };
  auto const groups = [&numbers](std::string const& name, VocabularyTables::OwnGroups const& values) {
    numbers(name + "_starts", values.starts);
    numbers(name + "_numbers", values.numbers);
  };
  texts("names", tables.names);
  groups("names_of_size", tables.names_of_size);
  letters("letters_by_size", tables.letters_by_size);
  write_array(out, "OddLetters", "odd_letters_by_size", tables.odd_letters_by_size,
              [&out](OddLetters set) { out << set; });
  texts("parts", tables.parts);
  numbers("places_of_parts", tables.places_of_parts);
  groups("parts_of", tables.parts_of);
  groups("names_ending_in", tables.names_ending_in);
  texts("families", tables.families);
  numbers("places_of_families", tables.places_of_families);
  groups("names_of_family", tables.names_of_family);
  letters("letters_by_family", tables.letters_by_family);
  return std::move(out).str();
}

}  // namespace axisc::schema::generator
