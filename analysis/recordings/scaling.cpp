#include "analysis/recordings/scaling.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axisc::recordings {

namespace {

struct Range {
  std::string_view type;
  double low, high;
};

template <class Number>
constexpr Range range_of(std::string_view type) {
  return {type, static_cast<double>(std::numeric_limits<Number>::min()),
          static_cast<double>(std::numeric_limits<Number>::max())};
}

constexpr std::array<Range, 9> ranges{{{"BIT", 0, 1},
                                       range_of<std::int8_t>("INT8"),
                                       range_of<std::int16_t>("INT16"),
                                       range_of<std::int32_t>("INT32"),
                                       range_of<std::int64_t>("INT64"),
                                       range_of<std::uint8_t>("UINT8"),
                                       range_of<std::uint16_t>("UINT16"),
                                       range_of<std::uint32_t>("UINT32"),
                                       range_of<std::uint64_t>("UINT64")}};

bool is_in(Range const& range, double value) {
  return value >= range.low && value <= range.high;
}

/// Scaled values are written with some 15 digits, those of REAL32 with 7.
bool is_nearly_whole(double value) {
  constexpr double tolerance = 1e-6;
  return std::abs(value - std::nearbyint(value)) <= tolerance * std::max(1.0, std::abs(value) * 1e-6);
}

struct UnitRow {
  std::string_view word;
  double thousandths;
};
/// Lower case.
constexpr std::array<UnitRow, 9> length_and_angle_units{{{"mm", 1e3},
                                                         {"µm", 1},  // U+00B5
                                                         {"μm", 1},  // U+03BC
                                                         {"um", 1},
                                                         {"nm", 1e-3},
                                                         {"cm", 1e4},
                                                         {"m", 1e6},
                                                         {"°", 1e3},
                                                         {"deg", 1e3}}};

}  // namespace

Scaling scaling_of(Channel const& channel) {
  auto const& scale = channel.scale;
  if (scale.is_identity()) return Scaling::none;
  if (channel.is_raw) return Scaling::raw;
  auto const* const range = std::find_if(ranges.begin(), ranges.end(),
                                         [&](Range const& row) { return row.type == channel.data_type; });
  if (range == ranges.end() || scale.factor == 0 || scale.unit_factor == 0) return Scaling::open;
  bool fits_raw = true;
  bool fits_shown = true;
  for_each_part(channel.values, [&](std::size_t, std::span<double const> values) {
    for (double const value : values) {
      if (std::isnan(value)) continue;
      double const raw = scale.raw(value);
      fits_raw = fits_raw && value == std::nearbyint(value) && is_in(*range, value);
      fits_shown = fits_shown && is_nearly_whole(raw) && is_in(*range, std::nearbyint(raw));
    }
  });
  if (fits_raw == fits_shown) return fits_raw ? Scaling::open : Scaling::neither;
  return fits_raw ? Scaling::raw : Scaling::shown;
}

bool names_unit(std::string_view unit) {
  return !unit.empty() && !ascii::equal_ignoring_case(unit, "(None)");
}

std::optional<double> thousandths_in(std::string_view unit) {
  auto const word = ascii::lower_case(unit.substr(0, unit.find_first_of(" (")));
  auto const* const found = std::find_if(length_and_angle_units.begin(), length_and_angle_units.end(),
                                         [&](UnitRow const& row) { return row.word == word; });
  if (word.empty() || found == length_and_angle_units.end()) return std::nullopt;
  return found->thousandths;
}

}  // namespace axisc::recordings
