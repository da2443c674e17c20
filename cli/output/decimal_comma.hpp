// A comma separates the values of a list, and German numbers have one before their fraction.
#pragma once

#include <optional>
#include <string>

namespace axisc::cli {

struct Invocation;

/// A warning on standard error where a list of two values may be one number that is written in German:
/// "48,5Hz". None for fractions that nobody writes, of three digits or with a 0 at the end ("10,20").
void remark_decimal_comma(Invocation const& invocation, std::string const& option,
                          std::optional<std::string> const& list);

}  // namespace axisc::cli
