// Writes rows of a catalogue as a constant table in C++.
#pragma once

#include "schema/parameter_row.hpp"

#include <cstddef>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace axisc::schema::generator {

/// The names of the tables begin with the prefix: `channel_parameter_table`.
class RowWriter {
 public:
  RowWriter(std::ostream& out, std::string prefix, std::span<ParameterRow const> rows)
      : out_(out), prefix_(std::move(prefix)), rows_(rows) {}

  void write();

 private:
  void write_symbol_set(ParameterRow::Words const& symbols);
  void write_limit(char const* member, Limit const& limit);
  void write_text(char const* member, std::string const& text);
  /// Returns the number of slots of the row.
  std::size_t write_parameter(std::size_t row, std::size_t first_slot);

  std::ostream& out_;
  std::string prefix_;
  std::span<ParameterRow const> rows_;
  std::map<std::string, std::string> symbol_sets_;  ///< name of the table by its text
  std::vector<std::string> set_names_;              ///< symbols and number names of each row
};

/// A literal.
[[nodiscard]] std::string quoted(std::string const& text);

}  // namespace axisc::schema::generator
