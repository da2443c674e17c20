// The values of number tokens. The grammar recognises a number; these functions convert it, correctly
// rounded.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::grammar {

/// An integer of any data type from SGN08 to UNS64. Zero is never negative.
struct IntegerValue {
  bool negative = false;
  std::uint64_t magnitude = 0;
  friend constexpr bool operator==(IntegerValue const&, IntegerValue const&) = default;
};

/// Value of an `integer` or `hexadecimal` token; none when the magnitude exceeds 2^64 - 1 (or `token` is
/// neither).
[[nodiscard]] std::optional<IntegerValue> integer_value(std::string_view token);

/// The double nearest to an `integer` or `real` token; none when it is too big for a double (or `token` is
/// neither). A value too small for a double is 0.
[[nodiscard]] std::optional<double> real_value(std::string_view token);

}  // namespace axisc::grammar
