// Numbers as text, whatever the locale: with a decimal point for files, because that is what the control
// reads, and for readers, with the decimal sign of their language.
#pragma once

#include "diagnostics/wording.hpp"

#include <string>

namespace axisc {

/// The shortest decimal text that reads back as exactly this double: "0.1", "12000", "1e-07". Between 1e-5
/// and 1e15 (and for 0) plain notation, outside with an exponent; "inf", "-inf" and "nan" for values that are
/// not numbers; "-0" keeps its sign.
[[nodiscard]] std::string format_exact(double value);

/// format_exact() for readers.
[[nodiscard]] Wording exact_number(double value);

/// `value` rounded to `significant_digits` (1 to 17) for readers: "6.28", "0.00123", "1.2e-07". No trailing
/// zeros and no negative zero. Digits before the point are never rounded away: 1234.6 with three digits is
/// "1235", not "1230".
[[nodiscard]] Wording format_rounded(double value, int significant_digits);

/// `value` with this many decimals, for columns: "6.280".
[[nodiscard]] Wording format_fixed(double value, int decimals);

}  // namespace axisc
