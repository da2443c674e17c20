// What the numbers of a channel are: raw, as the control has them, or as the scope shows them.
//
// The header of a text says how raw values are scaled, but not whether they were: two exports of one
// recording with one header differ by exactly that.
#pragma once

#include "analysis/recordings/recording.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::recordings {

enum class Scaling : std::uint8_t {
  none,     ///< nothing is scaled: raw and shown values are the same
  raw,      ///< the numbers are raw values
  shown,    ///< the numbers are scaled
  open,     ///< they may be either: a real type, or all values fit both
  neither,  ///< no value of the type gives these numbers, raw or scaled
};

/// Of a binary file, raw; of a text, raw where all numbers fit the data type, shown where all do when the
/// scale is taken back. Cost: a pass over the values.
[[nodiscard]] Scaling scaling_of(Channel const& channel);

/// What a unit in a header is, in µm or 0.001°: "mm" is 1000, "°" 1000. None for "(None)", and for what is
/// not a length or an angle.
[[nodiscard]] std::optional<double> thousandths_in(std::string_view unit);

/// The header names a unit: neither empty nor "(None)".
[[nodiscard]] bool names_unit(std::string_view unit);

}  // namespace axisc::recordings
