// Arithmetic of NC programs: P1 * 2 + SIN[V.P.ANGLE], and conditions: P1 < 10 AND V.P.A != 0.
//
//   condition  = comparison { "AND" comparison } { "OR" … }  comparison = sum [ ("==" | "!=" | "<" | …) sum ]
//   sum        = product { ("+" | "-") product }             product    = factor { ("*" | "/") factor }
//   factor     = [sign] ( number | variable | function "[" condition "]" | "[" condition "]" )
//   variable   = P1 | V.P.NAME                               function   = ABS SQRT SIN COS TAN INT NOT
//
// Angles are degrees, true is 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::grammar {

enum class Operation : std::uint8_t {
  number,
  variable,
  negate,
  absolute,
  square_root,
  sine,
  cosine,
  tangent,
  whole_part,
  logical_not,
  add,
  subtract,
  multiply,
  divide,
  equal,
  unequal,
  less,
  less_or_equal,
  greater,
  greater_or_equal,
  logical_and,
  logical_or,
};

/// An expression in the order in which a stack computes it.
struct Expression {
  struct Step {
    Operation operation{};
    double number = 0;
    std::string variable;
  };
  std::vector<Step> steps;
  std::size_t size = 0;  ///< bytes of the text that belong to it
};

/// Reads as much of the text as is an expression; nothing where it does not begin with one, or where brackets
/// are nested deeper than 32.
[[nodiscard]] std::optional<Expression> parse_expression(std::string_view text);

/// Nothing where a variable has no value or the result is not a finite number.
[[nodiscard]] std::optional<double> value_of(
    Expression const& expression, std::function<std::optional<double>(std::string const&)> const& variable);

}  // namespace axisc::grammar
