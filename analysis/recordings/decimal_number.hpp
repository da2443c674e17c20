// Numbers as texts have them, with a decimal point or a decimal comma.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::recordings {

enum class DecimalMark : std::uint8_t { none, point, comma };

struct DecimalNumber {
  double value = 0;  ///< the nearest double
  DecimalMark mark = DecimalMark::none;
};

/// All of `text`: "-1.5", "+3", "0,2", "1e-7", also "inf" and "nan". Cost: some nanoseconds.
[[nodiscard]] std::optional<DecimalNumber> parse_number(std::string_view text);

/// Decimal digits, or hexadecimal ones after "0x".
[[nodiscard]] std::optional<std::uint64_t> parse_whole(std::string_view text);

}  // namespace axisc::recordings
