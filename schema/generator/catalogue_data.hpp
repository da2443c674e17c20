// The catalogue as the generator sees it: the rows of axis-parameters.json, checked.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace axisc::schema::generator {

/// What is wrong with the data, in words for whoever edits it.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LimitData {
  bool open = false;
  std::optional<double> number;  ///< limits of a data type as numbers
  std::uint16_t p_axis = 0;      ///< the limiting parameter, where there is no number
};

struct SymbolData {
  std::string word;
  std::optional<int> number;
};

struct ParameterData {
  std::string name;
  std::uint16_t p_axis = 0;
  std::string type;
  std::vector<std::uint16_t> array;
  std::optional<std::string> default_text;
  std::string unit_translatory, unit_rotary;
  std::optional<LimitData> minimum, maximum;
  std::vector<SymbolData> symbols;
  std::vector<SymbolData> number_names;
  std::uint16_t max_length = 0;
  std::string axis_types;
  std::string since;
};

/// Reads `data_text` and checks it: against the JSON schema `schema_text`, then row by row and across rows. Throws
/// DataError with one line per mistake.
[[nodiscard]] std::vector<ParameterData> read_catalogue(std::string const& data_text,
                                                        std::string const& schema_text);

}  // namespace axisc::schema::generator
