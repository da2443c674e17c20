#include "presentation/quantity.hpp"

#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::presentation::says {

constexpr Sentence cycles{"cycles", "Zyklen"};
constexpr Sentence bytes{"bytes", "Bytes"};
constexpr Sentence micro_seconds{"µs", "µs"};
constexpr Sentence milli_seconds{"ms", "ms"};
constexpr Sentence seconds{"s", "s"};
constexpr Sentence hertz{"Hz", "Hz"};
constexpr Sentence decibels{"dB", "dB"};
constexpr Sentence degrees{"°", "°"};
constexpr Sentence radians{"rad", "rad"};
constexpr Sentence percent{"%", "%"};
constexpr Sentence micro_metres{"µm", "µm"};
constexpr Sentence milli_metres{"mm", "mm"};
constexpr Sentence velocity{"mm/s", "mm/s"};
constexpr Sentence slow_velocity{"µm/s", "µm/s"};
constexpr Sentence feed{"mm/min", "mm/min"};
constexpr Sentence turning{"°/s", "°/s"};
constexpr Sentence small_acceleration{"mm/s²", "mm/s²"};
constexpr Sentence acceleration{"m/s²", "m/s²"};
constexpr Sentence turning_faster{"°/s²", "°/s²"};

}  // namespace axisc::presentation::says

namespace axisc::presentation {

namespace {

struct UnitRow {
  Unit unit;
  SentenceRef symbol;
};

constexpr std::array units{
    UnitRow{Unit::cycle, says::cycles},
    UnitRow{Unit::microsecond, says::micro_seconds},
    UnitRow{Unit::millisecond, says::milli_seconds},
    UnitRow{Unit::second, says::seconds},
    UnitRow{Unit::hertz, says::hertz},
    UnitRow{Unit::decibel, says::decibels},
    UnitRow{Unit::degree, says::degrees},
    UnitRow{Unit::radian, says::radians},
    UnitRow{Unit::percent, says::percent},
    UnitRow{Unit::share, says::percent},
    UnitRow{Unit::micrometre, says::micro_metres},
    UnitRow{Unit::millimetre, says::milli_metres},
    UnitRow{Unit::millimetre_per_second, says::velocity},
    UnitRow{Unit::micrometre_per_second, says::slow_velocity},
    UnitRow{Unit::millimetre_per_minute, says::feed},
    UnitRow{Unit::degree_per_second, says::turning},
    UnitRow{Unit::millimetre_per_second_squared, says::small_acceleration},
    UnitRow{Unit::metre_per_second_squared, says::acceleration},
    UnitRow{Unit::degree_per_second_squared, says::turning_faster},
    UnitRow{Unit::byte, says::bytes},
};

UnitRow const* row_of(Unit unit) {
  auto const* const found =
      std::find_if(units.begin(), units.end(), [unit](UnitRow const& row) { return row.unit == unit; });
  return found == units.end() ? nullptr : found;
}

Wording number_of(double value, Digits digits) {
  switch (digits.kind) {
    case Digits::Kind::exact: return exact_number(value);
    case Digits::Kind::significant: return format_rounded(value, digits.count);
    case Digits::Kind::decimals:
      // A number that rounds to zero has no sign.
      return format_fixed(std::abs(value) < std::pow(10.0, -digits.count) / 2 ? 0 : value, digits.count);
  }
  return {};
}

}  // namespace

std::string number_text(Quantity const& quantity, Language language) {
  if (std::isnan(quantity.value)) return "-";
  if (std::isinf(quantity.value)) return quantity.value > 0 ? "∞" : "-∞";
  constexpr double percent = 100;
  double const value = quantity.unit == Unit::share ? quantity.value * percent : quantity.value;
  return number_of(value, quantity.digits).in(language);
}

std::string quantity_text(Quantity const& quantity, Language language) {
  std::string text = number_text(quantity, language);
  if (quantity.unit == Unit::none || text == "-") return text;
  if (quantity.unit != Unit::degree) text += ' ';
  return text.append(symbol(quantity.unit, language));
}

std::string_view symbol(Unit unit, Language language) {
  auto const* const row = row_of(unit);
  return row == nullptr ? std::string_view{} : row->symbol.in(language);
}

std::string json_number(double value) {
  return std::isfinite(value) ? format_exact(value) : "null";
}

}  // namespace axisc::presentation
