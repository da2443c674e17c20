// A parameter's value with its type resolved.
#pragma once

#include <cstdint>
#include <string>

#include "schema/catalogue.hpp"

namespace axisc::validator {

/// Numbers of every kind, booleans and numbered symbols carry `number`; words and strings carry `text` as well.
/// Integers are exact up to 2^53, which every parameter but one (an UNS64 counter) stays below.
struct Value {
  double number = 0;
  std::string text;  ///< string, or the word of a symbol (also when the list wrote its number)

  [[nodiscard]] bool flag() const { return number != 0; }
};

}  // namespace axisc::validator
