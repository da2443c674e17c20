// Numbers and times as written on the command line and in CSV files.
#pragma once

#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// A decimal number, correctly rounded, with an optional sign; "inf" and "nan" count as numbers. None if the
/// text is anything else or beyond the range of double.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A decimal number as parse_number() reads it, without "inf" and "nan".
[[nodiscard]] std::optional<double> parse_finite(std::string_view text);

/// A number above 0; Failure for any other value of `option`, and for one that has its unit.
[[nodiscard]] double positive_number(std::string const& option, std::string const& word,
                                     std::string const& unit);

/// A whole number from 1 to `most`; Failure for any other value of `option`.
[[nodiscard]] std::uint64_t positive_count(std::string const& option, std::string const& word,
                                           std::uint64_t most = UINT64_MAX);

/// A decimal integer without sign.
[[nodiscard]] std::optional<std::uint64_t> parse_count(std::string_view text);

/// NC cycle time: "1ms", "250us", "250µs", "0.5ms", "125000ns", "0.001s", or a bare number of microseconds.
/// None unless it is a whole number of nanoseconds from 1 ns to 1 s.
[[nodiscard]] std::optional<design::CycleTime> parse_cycle_time(std::string_view text);

/// "a,b,c" without blanks around the parts; empty parts are left out.
[[nodiscard]] std::vector<std::string> split_list(std::string_view text, char separator = ',');

/// "NAME" and "VALUE" of "NAME=VALUE"; none where one of them is empty.
struct Assigned {
  std::string name, value;
};
[[nodiscard]] std::optional<Assigned> parse_assigned(std::string const& text);

}  // namespace axisc
