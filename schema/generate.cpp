// axisc_schema_generator DATA DESCRIPTIONS OTHER_LISTS MESSAGES LOOKUP
//                        TABLES VOCABULARY DESCRIPTION_TABLES KIND_TABLES LOOKUP_TABLES
//
// Turns axis-parameters.json, axis-descriptions.json, other-lists.json, control-messages.json and lookup.json
// into constant tables while building. Exit status 1 and one line per mistake when the data is wrong.
#include "schema/generator/catalogue_data.hpp"
#include "schema/generator/description_writer.hpp"
#include "schema/generator/lookup_writer.hpp"
#include "schema/generator/table_writer.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace {

std::string read_file(std::string const& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw axisc::schema::generator::DataError("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_file(std::string const& path, std::string const& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text << std::flush;
  if (!file) throw axisc::schema::generator::DataError("cannot write " + path);
}

}  // namespace

int main(int argc, char* argv[]) {
  std::vector<std::string> const arguments(argv, argv + argc);
  if (arguments.size() != 11) {
    std::cerr << "usage: axisc_schema_generator DATA DESCRIPTIONS OTHER_LISTS MESSAGES LOOKUP TABLES "
                 "VOCABULARY DESCRIPTION_TABLES KIND_TABLES LOOKUP_TABLES\n";
    return 2;
  }
  try {
    auto const parameters = axisc::schema::generator::read_catalogue(read_file(arguments[1]));
    auto const descriptions =
        axisc::schema::generator::write_descriptions(parameters, read_file(arguments[2]));
    auto const kinds = axisc::schema::generator::read_kinds(read_file(arguments[3]));
    auto const lookup =
        axisc::schema::generator::write_lookup(parameters, read_file(arguments[4]), read_file(arguments[5]));
    write_file(arguments[6], axisc::schema::generator::write_tables(parameters));
    write_file(arguments[7], axisc::schema::generator::write_vocabulary(parameters));
    write_file(arguments[8], descriptions);
    write_file(arguments[9], axisc::schema::generator::write_kinds(kinds, parameters));
    write_file(arguments[10], lookup);
  } catch (std::exception const& error) {
    std::cerr << arguments[1] << ":\n" << error.what() << '\n';
    return 1;
  }
  return 0;
}
