// What the numbers of a recording mean for an axis.
#pragma once

#include "analysis/recordings/signal.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {

enum class RecordedUnit : std::uint8_t {
  recognised,
  tenths,     ///< 0.1 µm or 0.0001°, as CNC objects have it
  um,         ///< or 0.001°
  mm,         ///< or degrees
  increments  ///< of the measuring system: P-AXIS-00233 and P-AXIS-00234 say how long one is
};

/// Micrometres or 0.001° in a position unit of 0.1 µm or 0.0001°.
inline constexpr double thousandths_per_tenth = 0.1;

/// As people name them.
inline std::initializer_list<std::pair<std::string_view, RecordedUnit>> const recorded_units = {
    {"0.1um", RecordedUnit::tenths},
    {"um", RecordedUnit::um},
    {"mm", RecordedUnit::mm},
    {"incr", RecordedUnit::increments}};

/// All values outside the gaps are whole numbers.
[[nodiscard]] bool is_whole(recordings::Signal const& signal, std::vector<std::size_t> const& gaps);

/// µm, or 0.001°, of one unit. Where the unit is to be recognised, whole numbers are those of CNC objects.
/// Failure for increments of an axis whose image does not hold the lists' values.
[[nodiscard]] double thousandths_of(RecordedUnit unit, image::ImageAxis const& axis, bool is_whole);

/// By how many µm or 0.001° the position of the axis jumps where its modulo range ends (P-AXIS-00126,
/// P-AXIS-00127); a full turn of a rotary axis if the lists do not say. None for an axis without such a
/// range.
[[nodiscard]] std::optional<double> modulo_range(image::ImageAxis const& axis);

}  // namespace axisc
